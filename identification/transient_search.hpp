#pragma once

#include "hydraulics/circuit/circuit_sample.hpp"
#include "identification/circuit_problem.hpp"
#include "identification/identification_way.hpp"
#include "runtime/random.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace placedpar::identification {

/// The answer of the search after a sample.
struct TransientEstimate {
    std::size_t index; ///< index of the sample in the record
    double time_s;
    bool frozen;            ///< whether the gate was shut; if so, the compliance is unchanged
    double error_in3_per_s; ///< rms error of the best individual over the window
    std::vector<double> compliance_in3_per_psi;
};

struct SearchRun {
    std::vector<TransientEstimate> estimates;
    std::uint64_t generations = 0;
};

/// The answer of a simulated machine that receives each sample when the sample is taken.
struct AnswerInTime {
    std::vector<double> compliance_in3_per_psi; ///< in the circuit's order
    std::string process;                        ///< the search whose answer is the fittest
    double sample_s = 0;                        ///< time of the last sample that was searched
    double after_s = 0;                         ///< time from that sample to the answer
    bool keeps_pace = true;    ///< whether each answer is ready within one sampling period of its sample
    std::string warnings = {}; ///< warnings about the netlist; "" if there are none
};

/// Throws UnfitRecord if there are too few samples for the first generation.
void require_samples(std::span<const hydraulics::CircuitSample> samples, const IdentificationWay& way);

/// Runs one search over the samples. Unlike run_traditional(), it stops while the gate is shut (excitation_gate.hpp),
/// and it empties the window at a gap in the record. Throws what require_samples() throws.
SearchRun search_transient(const CircuitProblem& problem, std::span<const hydraulics::CircuitSample> samples,
                           const IdentificationWay& way, RandomStream random);

} // namespace placedpar::identification
