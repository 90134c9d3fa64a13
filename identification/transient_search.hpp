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

/// The compliances that the search has found when it has used one more sample.
struct TransientEstimate {
    std::size_t index; ///< index of the sample in the record
    double time_s;
    bool frozen; ///< whether the pressure changed too slowly (excitation_gate.hpp); the compliance is then unchanged
    double error_in3_per_s; ///< rms error of the best individual over the window
    std::vector<double> compliance_in3_per_psi;
};

struct SearchRun {
    std::vector<TransientEstimate> estimates;
    std::uint64_t generations = 0;
};

/// The answer of a simulated network of transputers that receives each sample at the time at which the sensors take it.
struct AnswerInTime {
    std::vector<double> compliance_in3_per_psi; ///< in the circuit's order
    std::string process;                        ///< the searching process whose answer has the greatest fitness
    double sample_s = 0;                        ///< time of the last sample that was searched
    double after_s = 0;                         ///< time from that sample to the answer
    bool keeps_pace = true;    ///< whether each answer is ready within one sampling period of its sample
    std::string warnings = {}; ///< warnings about the netlist; "" if there are none
};

/// Throws UnfitRecord if there are too few samples for the first generation.
void require_samples(std::span<const hydraulics::CircuitSample> samples, const IdentificationWay& way);

/// Runs one search over the samples, on the computer and not on simulated transputers. Unlike run_traditional(), stops
/// the search while the pressure changes too slowly (excitation_gate.hpp), and empties the window of samples at a gap
/// in the record. Throws what require_samples() throws.
SearchRun search_transient(const CircuitProblem& problem, std::span<const hydraulics::CircuitSample> samples,
                           const IdentificationWay& way, RandomStream random);

} // namespace placedpar::identification
