// Tests the verdicts on claims, and when a claim misses.

#include "experiments/kit/claims.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

using namespace placedpar;

namespace {

Claim claim_of(std::vector<double> values, std::optional<double> at_least, std::optional<double> at_most = {}) {
    return {
        .text = "lag", .unit = "generations", .values = std::move(values), .at_least = at_least, .at_most = at_most};
}

std::vector<double> six(double value) { return std::vector<double>(6, value); }

std::vector<double> from_1_to(int last) {
    std::vector<double> values(static_cast<std::size_t>(last));
    std::iota(values.begin(), values.end(), 1.0);
    return values;
}

Claim expected(ClaimVerdict verdict, Claim claim) {
    claim.expected = verdict;
    return claim;
}

bool misses(const Claim& claim) { return !claims_comparison("claims", {claim}).within_tolerance(); }

} // namespace

TEST_CASE("a claim holds where the whole interval of the median is on its side, and is undecided where a part is") {
    CHECK(verdict_of(claim_of(six(6), 5)) == ClaimVerdict::holds);
    CHECK(verdict_of(claim_of(six(6), 6)) == ClaimVerdict::holds); // the bound itself counts
    CHECK(verdict_of(claim_of(six(4), 5)) == ClaimVerdict::fails);
    CHECK(verdict_of(claim_of(six(4), {}, 5)) == ClaimVerdict::holds);
    CHECK(verdict_of(claim_of(from_1_to(40), 20)) == ClaimVerdict::undecided);
    CHECK(verdict_of(claim_of(from_1_to(40), 1, 40)) == ClaimVerdict::holds);
    CHECK(verdict_of(claim_of(from_1_to(40), 20, 21)) == ClaimVerdict::undecided); // only the median lies between
    CHECK(verdict_of(claim_of(from_1_to(12), 7.5, 7.6)) ==
          ClaimVerdict::undecided); // the interval goes beyond both bounds
    CHECK(verdict_of(claim_of(six(4), 5, 6)) == ClaimVerdict::fails);
}

TEST_CASE("five runs decide no claim") {
    const std::vector<double> five(5, 6);
    CHECK(verdict_of(claim_of(five, 5)) == ClaimVerdict::undecided);
    CHECK(verdict_of(claim_of(five, 7)) == ClaimVerdict::undecided);
    CHECK(verdict_of(claim_of(five, 7, 8)) == ClaimVerdict::undecided);
    const Claim wrong = claim_of(five, 7);
    CHECK_FALSE(misses(wrong));
    CHECK(print_comparison(claims_comparison("claims", {wrong})).find("undecided") != std::string::npos);
}

TEST_CASE("a table of claims has the median, its interval and the bound, with as many decimals as that needs") {
    const Comparison table =
        claims_comparison("claims", {claim_of(six(6), 5), claim_of(six(0.02), 0.0125), claim_of(six(6), 5, 7)});
    REQUIRE(table.cells.size() == 9);
    CHECK(table.against == "claim");
    CHECK(table.cells[0].simulated == 6);
    CHECK(table.cells[0].reference == 5.0);
    CHECK(table.cells[0].decimals == 2);
    CHECK(table.cells[1].simulated == 6); // from
    CHECK(table.cells[2].simulated == 6); // to
    CHECK(table.cells[3].decimals == 4);
    CHECK_FALSE(table.cells[3].reference_to);
    CHECK(table.cells[6].reference_to == 7.0);
    CHECK(table.notes == "lag: claimed at least 5: holds\n"
                         "lag: claimed at least 0.0125: holds\n"
                         "lag: claimed at least 5 and at most 7: holds\n");
    CHECK(std::ranges::count_if(table.cells, &Cell::is_judged) == 3); // the medians
}

TEST_CASE("a claim misses only if its verdict is the contrary of the expected one") {
    using enum ClaimVerdict;
    const Claim clear = claim_of(six(6), 5), wrong = claim_of(six(4), 5), open = claim_of(from_1_to(40), 20);
    CHECK_FALSE(misses(expected(holds, clear)));
    CHECK(misses(expected(holds, wrong)));
    CHECK(misses(expected(fails, clear)));
    CHECK_FALSE(misses(expected(fails, wrong)));
    CHECK_FALSE(misses(expected(holds, open)));
    CHECK_FALSE(misses(expected(fails, open)));
    CHECK(misses(expected(fails, claim_of(six(4), {}, 5))));
    CHECK_FALSE(misses(expected(fails, claim_of(six(6), {}, 5))));
    CHECK(misses(expected(holds, claim_of(six(8), 5, 7))));
    CHECK_FALSE(misses(expected(fails, claim_of(six(8), 5, 7))));
    CHECK(misses(expected(fails, claim_of(six(6), 5, 7))));
}

TEST_CASE("a claim is judged by the thesis unless it is ours") {
    CHECK(count_judged({claims_comparison("claims", {claim_of(six(6), 5)})}).thesis == 1);
    CHECK(count_judged({claims_comparison("claims", {claim_of(six(6), 5)}, Judge::own)}).own == 1);
}
