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

/// The state of the links of a circuit at one instant.
struct CircuitSample {
    std::size_t index; ///< index in the record
    double time_s;
    std::vector<LinkSample> links; ///< in the circuit's order
    std::size_t stretch = 0;       ///< index of the part of the record between two gaps

    /// Returns the values of all links, one link after the other, as CircuitProblem reads them.
    std::vector<double> values() const;

    friend bool operator==(const CircuitSample&, const CircuitSample&) = default;
};

/// Returns a sample for every instant of the record at which the slopes are known: two samples precede it and two
/// follow it without a gap. A slope is the slope of the line fitted to 5 samples (line_fit.hpp). Throws UnfitRecord,
/// which names the missing channel and the channels present, if the record lacks the pressure, the angle or the source
/// of the areas of a link of the circuit.
std::vector<CircuitSample> circuit_samples(const Record& record, const Circuit& circuit,
                                           const LinkCalibrations& calibrations);

/// Returns whether flow enters every link, and would still enter it if each link's pressure were `margin_psi` higher.
/// Uses the steady flow of the circuit (junction_flow.hpp). On an outlet side, returns whether flow leaves the link,
/// and would still leave it if its pressure were `margin_psi` lower.
bool all_open(const Circuit& circuit, std::span<const LinkSample> links, const FlowConstants& flow, double margin_psi);

/// Returns the rms slope of the pressure of one link. REQUIRES: there is a sample.
double excitation_psi_per_s(std::span<const CircuitSample> samples, std::size_t junction);

/// The rule by which identification chooses the samples that it uses. The rule is ours; the thesis says only "during
/// the transient period".
struct UsableSamples {
    double open_by_psi = 25;            ///< margin of all_open() at the first sample
    double first_slope_psi_per_s = 150; ///< least slope of every pressure at the first sample
    std::size_t skipped = 0;            ///< number of usable samples to leave out at the beginning
    std::size_t count = 20;             ///< greatest number of samples; 20 samples last 0.4 s (thesis 4.4)
    bool rising = false;                ///< whether to stop at the first falling pressure (thesis 3.1.3)
};

/// Returns up to `count` samples, from the first sample that the rule accepts. Later samples are left out if an inlet
/// is shut or the pumps cannot reach a cylinder's pressure, since equation 3.6 does not hold there. Returns fewer
/// samples if the record ends, or if `rising` is set and a pressure falls.
std::vector<CircuitSample> usable_samples(std::span<const CircuitSample> samples, const Circuit& circuit,
                                          const FlowConstants& flow, const UsableSamples& rule = {});

} // namespace placedpar::hydraulics
