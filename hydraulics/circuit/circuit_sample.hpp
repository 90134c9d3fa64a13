#pragma once

#include "hydraulics/circuit/circuit.hpp"
#include "hydraulics/circuit/flow_constants.hpp"
#include "hydraulics/circuit/link_calibration.hpp"
#include "hydraulics/circuit/link_sample.hpp"
#include "hydraulics/data/record.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace placedpar::hydraulics {

/// What the links of a circuit did at one instant.
struct CircuitSample {
    std::size_t index; ///< in the record
    double time_s;
    std::vector<LinkSample> links; ///< in the circuit's order
    std::size_t stretch = 0;       ///< of the record, between its gaps

    /// As plain numbers, end to end: a sample of CircuitProblem.
    std::vector<double> values() const;
};

/// Every instant of the record at which the slopes are known: two samples on either side, none missing. Slopes
/// from 5-point lines.
/// Throws UnfitRecord, naming the missing channel and those there are, when a link of the circuit lacks its pressure,
/// its angle or what its areas come from.
std::vector<CircuitSample> circuit_samples(const Record& record, const Circuit& circuit,
                                           const LinkCalibrations& calibrations);

/// Does flow enter every link, and would it if each link's pressure were `margin_psi` higher? By the steady flow of
/// the circuit (junction_flow.hpp).
bool all_open(const Circuit& circuit, std::span<const LinkSample> links, const FlowConstants& flow, double margin_psi);

/// How fast the pressure of one link moves: the rms slope. REQUIRES: not empty.
double excitation_psi_per_s(std::span<const CircuitSample> samples, std::size_t junction);

/// Which samples identification may use (ours; the thesis says "during the transient period").
struct UsableSamples {
    double open_by_psi = 25;            ///< the first sample: all open, by this margin ...
    double first_slope_psi_per_s = 150; ///< ... and every pressure rises faster than this
    std::size_t skipped = 0;            ///< samples left out after that
    std::size_t count = 20;             ///< 0.4 s of transient, thesis 4.4
    bool rising = false;                ///< nothing from the first falling pressure on, thesis 3.1.3
};

/// Starts at the first sample that the rule accepts and leaves out later ones where an inlet is shut or the
/// pumps cannot reach a cylinder's pressure, since equation 3.6 does not hold there. Fewer than `count` when
/// the record ends.
std::vector<CircuitSample> usable_samples(std::span<const CircuitSample> samples, const Circuit& circuit,
                                          const FlowConstants& flow, const UsableSamples& rule = {});

} // namespace placedpar::hydraulics
