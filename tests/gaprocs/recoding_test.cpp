#include "gaprocs/recoding.hpp"

#include <doctest/doctest.h>

#include <stdexcept>

using namespace placedpar;

namespace {

std::string read(const Recoding& recoding, const char* bred) {
    return recoding.to_problem(Genome::from_string(bred)).to_string();
}

} // namespace

TEST_CASE("a bred string may have the problem's own fields, in natural binary, in Gray code or with don't-care bits") {
    CHECK(read(natural_recoding({2, 3}), "01110") == "01110");
    CHECK(read({.problem_bits = {2, 3}, .bits = {2, 3}, .coding = Coding::gray}, "01110") == "01100");
    Recoding stuffed{.problem_bits = {2, 1}, .bits = {2, 1}, .coding = NaturalCoding{1}};
    CHECK(stuffed.length() == 5); // string: a1 * a2 * a3
    CHECK(read(stuffed, "10011") == "101");
    CHECK(read(stuffed, "11001") == "101");
    stuffed.coding = NaturalCoding{2};
    CHECK(stuffed.length() == 7);
    CHECK(read(stuffed, "0111010") == "010");
}

TEST_CASE("without a bias point, most significant bits stand for the lower end of an interval") {
    Recoding coarse{.problem_bits = {2, 4}, .bits = {2, 2}};
    CHECK(coarse.length() == 4);
    CHECK(read(coarse, "1001") == "100100");
    coarse.coding = Coding::gray; // applies to the bred field: 11 in Gray code is 2
    CHECK(read(coarse, "0011") == "001000");
}

TEST_CASE("bred bits count steps around the bias point, limited to the field") {
    Recoding fine{.problem_bits = {2, 4}, .bits = {2, 2}, .around = Genome::from_string("011000")};
    CHECK(read(fine, "1000") == "100110"); // second field: 8 - 2; the first field ignores the bias point
    CHECK(read(fine, "1011") == "101001"); // second field: 8 + 1
    fine.around = Genome::from_string("010000");
    CHECK(read(fine, "1000") == "100000");
    fine.around = Genome::from_string("011111");
    CHECK(read(fine, "1011") == "101111");
}

TEST_CASE("recodings without fields, with too many bits or too few are refused") {
    CHECK_THROWS_AS(Recoding{}.validate(), std::invalid_argument);
    CHECK_THROWS_AS((Recoding{.problem_bits = {2}, .bits = {3}}.validate()), std::invalid_argument);
    CHECK_THROWS_AS((Recoding{.problem_bits = {2}, .bits = {0}}.validate()), std::invalid_argument);
    CHECK_THROWS_AS((Recoding{.problem_bits = {2, 2}, .bits = {2}}.validate()), std::invalid_argument);
    CHECK_THROWS_AS((Recoding{.problem_bits = {4}, .bits = {2}, .around = Genome(3)}.validate()),
                    std::invalid_argument);
    CHECK_THROWS_AS((Recoding{.problem_bits = {2}, .bits = {2}, .coding = Coding::real}.validate()),
                    std::invalid_argument);
    CHECK_NOTHROW(natural_recoding({1, 63}).validate());
}
