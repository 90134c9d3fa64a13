#pragma once

#include "hydraulics/circuit/circuit.hpp"
#include "hydraulics/circuit/flow_constants.hpp"
#include "hydraulics/circuit/link_sample.hpp"
#include "hydraulics/data/record.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace placedpar::hydraulics {

/// Where the areas of a link's orifices come from: as they were read, or by the boom's functions A.3 to A.9 from the
/// spool, or from the servo-valve's voltage by A.1 and A.2.
enum class AreasFrom : unsigned char { areas, spool, servo };

/// How the readings of a link become flows and areas.
struct LinkReading {
    double piston_flow_in3_per_deg = 0; // what the pump side takes up a degree of the joint: A_i r pi / 180
    double spool_offset_in = 0;         // by which the spool's readings, or A.1, are too high
    double spool_lag_per_s = 0;         // a_0 of A.2
    std::optional<AreasFrom> from = {}; // none: the first of the three that the record has
};
using LinkReadings = std::array<LinkReading, all_links.size()>; // by index_of(link)

/// As asked for, or the first of the three that the record has of the link.
AreasFrom areas_from(const Record& record, Link link, const LinkReading& reading);

/// What the links of a circuit did at one instant.
struct CircuitSample {
    std::size_t index; // in the record
    double time_s;
    std::vector<LinkSample> links; // in the circuit's order
    std::size_t stretch = 0;       // of the record, between its gaps

    /// As plain numbers, end to end: a sample of CircuitProblem.
    std::vector<double> values() const;
};

/// Every instant of the record at which the slopes are known: two samples on either side, none missing. Slopes
/// from 5-point lines.
/// Throws UnfitRecord, naming the channel and those there are, when a link of the circuit lacks pressure, angle, or
/// what its areas come from.
std::vector<CircuitSample> circuit_samples(const Record& record, const Circuit& circuit, const LinkReadings& readings);

/// Are all inlets open and all load checks, even if every link's pressure were `margin_psi` higher? By the steady
/// flow of the circuit (junction_flow.hpp).
bool all_open(const Circuit& circuit, std::span<const LinkSample> links, const FlowConstants& flow, double margin_psi);

/// How fast the pressure of one link moves: the rms slope. REQUIRES: not empty.
double excitation_psi_per_s(std::span<const CircuitSample> samples, std::size_t junction);

/// Which samples identification may use (ours; the thesis says "during the transient period").
struct UsableSamples {
    double open_by_psi = 25;            // the first sample: all open, by this margin ...
    double first_slope_psi_per_s = 150; // ... and every pressure rises faster than this
    std::size_t skipped = 0;            // samples left out after that
    std::size_t count = 20;             // 0.4 s of transient, thesis 4.4
    bool rising = false;                // nothing from the first falling pressure on, thesis 3.1.3
};

/// Starts at the first sample that the rule accepts and leaves out later ones where an inlet is shut or the
/// pumps cannot reach a cylinder's pressure, since equation 3.6 does not hold there. Fewer than `count` when
/// the record ends.
std::vector<CircuitSample> usable_samples(std::span<const CircuitSample> samples, const Circuit& circuit,
                                          const FlowConstants& flow, const UsableSamples& rule = {});

} // namespace placedpar::hydraulics
