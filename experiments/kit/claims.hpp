#pragma once

#include "report/comparison.hpp"

#include <optional>
#include <string>
#include <vector>

namespace placedpar {

enum class ClaimVerdict { holds, fails, undecided };

/// Returns "holds", "does not hold" or "undecided".
const char* name_of(ClaimVerdict);

/// A claim of the thesis about a figure that varies with the seed: its median has a lower bound, an upper bound, or
/// both.
struct Claim {
    std::string text, unit;
    std::vector<double> values; ///< one for each seed
    std::optional<double> at_least, at_most;
    /// The verdict that the experiment's page states; `holds` if the page calls the claim undecided. If a claim with
    /// two bounds is expected to fail, its median is expected to be above both bounds.
    ClaimVerdict expected = ClaimVerdict::holds;

    std::optional<double> bound() const { return at_least ? at_least : at_most; }
};

/// Returns `holds` if the whole 95 % interval of the median is within the bounds, `fails` if the whole interval is
/// outside the bounds, otherwise `undecided`. With too few runs for an interval, a claim stays undecided.
ClaimVerdict verdict_of(const Claim&);

/// Returns a judged table of the claims, with the medians and their intervals as cells, and the verdicts as notes. A
/// claim that is expected to fail is outside its tolerance if it holds; any other claim is outside its tolerance if it
/// fails. `judge` is the source of the claims.
Comparison claims_comparison(std::string name, const std::vector<Claim>&, Judge judge = Judge::thesis);

} // namespace placedpar
