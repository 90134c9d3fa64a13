#pragma once

#include "hydraulics/circuit/circuit.hpp"
#include "hydraulics/circuit/circuit_sample.hpp"
#include "identification/circuit_problem.hpp"
#include "identification/transient_search.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::identification {

/// Why a compliance should not be believed as it stands: see flags.hpp.
enum class FlagKind : unsigned char {
    lower_bound,   ///< the answer is at the search's lower bound
    upper_bound,   ///< at its upper bound
    no_excitation, ///< the last window's pressure hardly moves
    misfit,        ///< the circuit's equations miss the flow by more than the bias allows
    still_valve,   ///< the valve reading never changes
    searches,      ///< the searches disagree
    halves,        ///< the two halves of the samples do
    uncertain,     ///< the standard error is too large a share of the answer
    offset,        ///< an offset of the spool was found that may be a leak
    vacuum,        ///< a pressure is below vacuum
    frozen,        ///< the pressure's sensor freezes
    falls          ///< the piston goes back while oil flows in
};

/// As results for machines name it: "lower_bound".
std::string_view name_of(FlagKind);

struct Flag {
    FlagKind kind;
    std::string text; ///< a sentence for people, with its figures
};

/// The compliance of one link, as identified.
struct LinkIdentified {
    hydraulics::Link link;
    double compliance_in3_per_psi; ///< the median of the searches
    double lowest, highest;        ///< 5 and 95 % of the searches
    double standard_error;         ///< of least squares on the last window: what the record's noise leaves uncertain
    std::optional<double> optimum; ///< the best of all codes on the last window; none above 20 bits (exhaustive_bits)
    std::optional<double> codes_from_optimum; ///< the searches' median distance from it
    std::vector<Flag> flags;                  ///< empty: nothing unusual

    bool flagged(FlagKind) const;
};

struct Identified {
    hydraulics::Circuit circuit;
    std::vector<LinkIdentified> links;        ///< in the circuit's order
    std::vector<TransientEstimate> estimates; ///< of the first search
    std::uint64_t generations = 0;            ///< of all searches

    bool flagged() const; ///< any link, with anything
};

/// Identifies the compliances of a circuit from its samples, without any simulated transputers. The first search draws
/// from the random stream (seed, "master"), as the process of that name in a netlist does, so that both give the same
/// answer; the others have streams of their own.
/// Throws UnfitRecord when there are not enough samples for the first generation, saying why.
Identified identify(const CircuitProblem& problem, const hydraulics::FlowConstants& flow,
                    std::span<const hydraulics::CircuitSample> samples, const IdentificationWay& way,
                    std::uint64_t seed);

} // namespace placedpar::identification
