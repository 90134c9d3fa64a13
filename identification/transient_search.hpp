#pragma once

#include "hydraulics/circuit/circuit_sample.hpp"
#include "identification/circuit_problem.hpp"
#include "identification/identification_way.hpp"
#include "runtime/random.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace placedpar::identification {

/// The search's answer after a sample.
struct TransientEstimate {
    std::size_t index; ///< of the sample in the record
    double time_s;
    bool frozen;            ///< by the gate: the estimate is the one before
    double error_in3_per_s; ///< rms over the window, of the best individual
    std::vector<double> compliance_in3_per_psi;
};

/// What one search found.
struct SearchRun {
    std::vector<TransientEstimate> estimates;
    std::uint64_t generations = 0;
};

/// One search over the samples. Differs from run_traditional() in two things:
/// the gate, and gaps of the record, after which the window begins anew. Throws UnfitRecord when there are not enough
/// samples for the first generation.
SearchRun search_transient(const CircuitProblem& problem, std::span<const hydraulics::CircuitSample> samples,
                           const IdentificationWay& way, RandomStream random);

} // namespace placedpar::identification
