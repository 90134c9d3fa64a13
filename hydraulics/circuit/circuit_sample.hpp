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

/// The measured state of the links of a circuit at one instant. A search for the compliances uses about 20 such
/// samples.
struct CircuitSample {
    std::size_t index; ///< index in the record
    double time_s;
    std::vector<LinkSample> links; ///< in the circuit's order
    std::size_t stretch = 0;       ///< number of the part of the record, counted from 0; parts end at gaps

    /// Returns the values of all links, one link after the other, in the order that LinkSample::from() reads.
    std::vector<double> values() const;

    friend bool operator==(const CircuitSample&, const CircuitSample&) = default;
};

/// Returns a sample for every instant of the record that has two readings before it and two after it without a gap. The
/// rates of change at an instant are slopes of lines fitted to these 5 readings (line_fit.hpp). Every link of the
/// circuit needs its pressure, its angle and the source of its orifice areas in the record. If one is missing, throws
/// UnfitRecord, which names the missing channel and the channels present.
std::vector<CircuitSample> circuit_samples(const Record& record, const Circuit& circuit,
                                           const LinkCalibrations& calibrations);

/// Returns whether oil enters every link even if each link's pressure is `margin_psi` higher than measured. The flows
/// come from the steady flow of the circuit (junction_flow.hpp). For a circuit of an outlet side, returns whether oil
/// leaves the link even if its pressure is `margin_psi` lower.
bool all_open(const Circuit& circuit, std::span<const LinkSample> links, const FlowConstants& flow, double margin_psi);

/// Returns the root mean square of the slopes of one link's pressure. The greater this value, the more the samples say
/// about the compliance. REQUIRES: there is a sample.
double excitation_psi_per_s(std::span<const CircuitSample> samples, std::size_t junction);

/// The rule by which identification chooses the samples that it uses. The thesis says only "during the transient
/// period", so this project chose the rule.
struct UsableSamples {
    double open_by_psi = 25;            ///< `margin_psi` of all_open() at the first sample
    double first_slope_psi_per_s = 150; ///< least rate at which every pressure changes at the first sample
    std::size_t skipped = 0;            ///< number of usable samples to leave out at the beginning
    std::size_t count = 20;             ///< greatest number of samples; 20 samples last 0.4 s (thesis 4.4)
    bool rising = false;                ///< true: the samples end before the first falling pressure (thesis 3.1.3)
};

/// Returns up to `count` samples, from the first sample that the rule accepts. A later sample is left out if an inlet
/// is shut or the pumps cannot reach a cylinder's pressure. In such a sample, equation 3.6 for the pressure at a
/// junction does not hold. Returns fewer samples if the record ends, or if `rising` is set and a pressure falls.
std::vector<CircuitSample> usable_samples(std::span<const CircuitSample> samples, const Circuit& circuit,
                                          const FlowConstants& flow, const UsableSamples& rule = {});

} // namespace placedpar::hydraulics
