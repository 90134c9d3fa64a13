#pragma once

#include "hydraulics/circuit/circuit.hpp"
#include "hydraulics/circuit/circuit_sample.hpp"
#include "identification/circuit_problem.hpp"
#include "identification/flag.hpp"
#include "identification/transient_search.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::identification {

/// What a search found for one link of the excavator.
struct LinkIdentified {
    hydraulics::Link link;
    double compliance_in3_per_psi = 0;
    double standard_error = 0; ///< standard error of least squares: over the last window of samples for identify(),
                               ///< over all samples for identify_whole()
    /// The compliance by least squares over all samples, for comparison. identify() computes it only for several links
    /// together.
    std::optional<LeastSquares> of_all_samples = {};
    /// The compliance that fits the last window best, found by trying every string. nullopt if the strings are too long
    /// for that (exhaustive_bits), or if this was not tried.
    std::optional<double> optimum = {};
    /// The distance of the answer from `optimum`, in steps between neighbouring codes.
    std::optional<double> codes_from_optimum = {};
    std::vector<Flag> flags = {}; ///< empty if nothing is unusual

    bool flagged(FlagKind) const;
};

struct Identified {
    hydraulics::Circuit circuit;
    std::vector<LinkIdentified> links; ///< in the circuit's order
    std::vector<TransientEstimate> estimates;
    std::uint64_t generations = 0;

    bool flagged() const; ///< whether any link has a flag
};

/// Identifies the compliances of a circuit from its samples, without simulated transputers. The search draws its random
/// numbers from the stream (seed, "master"). In a simulated network of transputers, the process "master" draws from the
/// same stream. Therefore this function and the network give the same answer. Throws UnfitRecord, with the reason, if
/// there are too few samples for the first generation.
Identified identify(const CircuitProblem& problem, const hydraulics::FlowConstants& flow,
                    std::span<const hydraulics::CircuitSample> samples, const IdentificationWay& way,
                    std::uint64_t seed);

} // namespace placedpar::identification
