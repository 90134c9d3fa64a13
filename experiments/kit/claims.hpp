#pragma once

#include "report/comparison.hpp"

#include <optional>
#include <string>
#include <vector>

namespace placedpar {

enum class ClaimVerdict { holds, fails, undecided };

/// Returns "holds", "does not hold" or "undecided".
const char* name_of(ClaimVerdict);

/// A statement of the thesis as a number: the median over seeds is at least or at most a bound.
struct Claim {
    std::string text, unit;
    std::vector<double> values; ///< one for each seed
    std::optional<double> at_least, at_most;
    /// The verdict that the page of the experiment states: `holds`, also where it is undecided, or `fails`. A claim
    /// with two bounds fails by a figure above both.
    ClaimVerdict expected = ClaimVerdict::holds;

    std::optional<double> bound() const { return at_least ? at_least : at_most; }
};

/// Returns `holds` if the whole 95 % interval of the median is on the claimed side, `fails` if none of it is.
ClaimVerdict verdict_of(const Claim&);

/// Returns the medians with their intervals as cells, and the verdicts as notes. The table is judged: a claim that is
/// expected to fail misses if it holds, and any other if it fails. `judge` states who makes the claims.
Comparison claims_comparison(std::string name, const std::vector<Claim>&, Judge judge = Judge::thesis);

} // namespace placedpar
