#include "experiments/kit/claims.hpp"

#include "experiments/kit/bootstrap.hpp"
#include "text/interval.hpp"
#include "text/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace placedpar {

namespace {

/// Returns whether a value is within the claim's bounds.
bool agrees(const Claim& claim, double value) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return value >= claim.at_least.value_or(-infinity) && value <= claim.at_most.value_or(infinity);
}

std::string bound_of(const Claim& claim) {
    std::string bound;
    if (claim.at_least)
        bound = fmt::format("at least {:g}", *claim.at_least);
    if (claim.at_most)
        bound += fmt::format("{}at most {:g}", bound.empty() ? "" : " and ", *claim.at_most);
    return bound;
}

/// Returns the number of decimals, from 2 to 6, that prints the bounds exactly.
int decimals_of(const Claim& claim) {
    auto fits = [](std::optional<double> bound, int decimals) {
        double shifted = bound.value_or(0) * std::pow(10, decimals);
        return std::abs(shifted - std::round(shifted)) < 1e-6;
    };
    int decimals = 2;
    while (decimals < 6 && !(fits(claim.at_least, decimals) && fits(claim.at_most, decimals)))
        ++decimals;
    return decimals;
}

/// Sets the cell's bounds such that the cell is outside its bounds if its whole interval contradicts the expected
/// verdict.
void set_bounds(Cell& cell, const Claim& claim, Interval interval) {
    cell.interval = interval;
    cell.at_least = claim.at_least;
    cell.at_most = claim.at_most;
    if (claim.expected != ClaimVerdict::fails)
        return;
    cell.at_least = claim.at_most;
    cell.at_most = claim.at_most ? std::nullopt : claim.at_least;
}

void add_interval(Comparison& comparison, const Claim& claim, Judge by) {
    Interval interval = median_interval(claim.values);
    int decimals = decimals_of(claim);
    Cell median =
        cell_of(claim.text, "median", claim.unit, claim.bound(), placedpar::median(claim.values), {}, decimals);
    if (claim.at_least && claim.at_most)
        median.reference_to = claim.at_most;
    set_bounds(median, claim, interval);
    comparison.add(judged_by(by, median));
    comparison.add(plain_cell(claim.text, "95 % from", claim.unit, interval.low, decimals));
    comparison.add(plain_cell(claim.text, "to", claim.unit, interval.high, decimals));
}

} // namespace

const char* name_of(ClaimVerdict verdict) {
    constexpr std::array names{"holds", "does not hold", "undecided"};
    return names[static_cast<std::size_t>(verdict)];
}

ClaimVerdict verdict_of(const Claim& claim) {
    Interval interval = median_interval(claim.values);
    if (agrees(claim, interval.low) && agrees(claim, interval.high))
        return ClaimVerdict::holds;
    const bool overlaps =
        interval.high >= claim.at_least.value_or(interval.high) && interval.low <= claim.at_most.value_or(interval.low);
    return overlaps ? ClaimVerdict::undecided : ClaimVerdict::fails;
}

Comparison claims_comparison(std::string name, const std::vector<Claim>& claims, Judge judge) {
    Comparison comparison{.name = std::move(name), .against = "claim", .judged = true};
    for (const Claim& claim : claims) {
        add_interval(comparison, claim, judge);
        comparison.notes +=
            fmt::format("{}: claimed {}: {}\n", claim.text, bound_of(claim), name_of(verdict_of(claim)));
    }
    return comparison;
}

} // namespace placedpar
