#include "gaprocs/representation/parameter_coding.hpp"
#include "gaprocs/representation/representation.hpp"
#include "runtime/random.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

using namespace placedpar;

namespace {

const Representation bits_of_5 = BitString(5), two_reals = RealVector({{0, 10}, {-1, 1}}), order_of_4 = Permutation(4);

std::string refusal_of_text(const Representation& representation, const char* text) {
    try {
        representation.read(text);
    } catch (const UserError& refused) {
        return refused.what();
    }
    return "";
}

} // namespace

TEST_CASE("random strings belong to their representation and are evenly distributed") {
    RandomStream random(1, "representation");
    std::map<std::string, int> orders;
    double sum = 0;
    for (int i = 0; i < 24000; ++i) {
        ++orders[order_of_4.text(order_of_4.random(random))];
        auto numbers = two_reals.reals().decode(two_reals.random(random));
        CHECK((numbers[0] >= 0 && numbers[0] < 10 && numbers[1] >= -1 && numbers[1] < 1));
        sum += numbers[0];
    }
    CHECK(orders.size() == 24);
    for (const auto& [order, count] : orders)
        CHECK(std::abs(count - 1000) < 160); // five standard deviations
    CHECK(std::abs(sum / 24000 - 5) < 0.1);
    CHECK(bits_of_5.random(random).size() == 5);
}

TEST_CASE("random binary strings are the same as those of random_population") {
    RandomStream one(1, "same"), other(1, "same");
    CHECK(Representation(BitString(130)).random_population(7, one) == random_population(7, 130, other));
}

TEST_CASE("a string written as text is read back the same") {
    for (const char* text : {"01101", "11111"})
        CHECK(bits_of_5.text(bits_of_5.read(text)) == text);
    for (const char* text : {"0.1 -0.25", "10 1", "1e-09 0"})
        CHECK(two_reals.text(two_reals.read(text)) == text);
    CHECK(two_reals.read(" 3,  0.5 ") == two_reals.read("3 0.5"));
    CHECK(order_of_4.text(order_of_4.read("2 0 3 1")) == "2 0 3 1");
    CHECK(order_of_4.permutation().decode(order_of_4.read("2 0 3 1")) == std::vector<std::size_t>{2, 0, 3, 1});
}

TEST_CASE("a text that is not a string of the representation is refused") {
    CHECK(refusal_of_text(bits_of_5, "0110") == "\"0110\" is not a string of 5 characters 0 and 1");
    CHECK(refusal_of_text(bits_of_5, "01102") == "\"01102\" is not a string of 5 characters 0 and 1");
    CHECK(refusal_of_text(two_reals, "1") == "\"1\" has 1 number, expected 2");
    CHECK(refusal_of_text(two_reals, "1 x") == "\"x\" is not a number");
    CHECK(refusal_of_text(two_reals, "1 1.5") == "1.5 is out of range: number 2 of a string may be from -1 to 1");
    CHECK(refusal_of_text(two_reals, "nan 0") == "nan is out of range: number 1 of a string may be from 0 to 10");
    CHECK(refusal_of_text(order_of_4, "0 1 2 4") ==
          "4 is not an element; a permutation has each number from 0 to 3 once");
    CHECK(refusal_of_text(order_of_4, "0 1 2 1") == "1 occurs twice; a permutation has each number from 0 to 3 once");
    CHECK(refusal_of_text(order_of_4, "0 1 2 -1") == "\"-1\" is not a whole number");
}

TEST_CASE(
    "the distance counts different bits, is Euclidean in widths of the ranges, or counts edges that are not shared") {
    CHECK(bits_of_5.distance(bits_of_5.read("01101"), bits_of_5.read("11100")) == 2);
    CHECK(two_reals.distance(two_reals.read("1 0"), two_reals.read("4 0.8")) == doctest::Approx(0.5));
    const Representation order_of_6 = Permutation(6);
    Genome tour = order_of_6.read("0 1 2 3 4 5");
    CHECK(order_of_6.distance(tour, order_of_6.read("3 2 1 0 5 4")) == 0); // the same tour in reverse
    CHECK(order_of_6.distance(tour, order_of_6.read("0 1 4 3 2 5")) == 2); // one part reversed
    CHECK(order_of_6.distance(tour, order_of_6.read("0 2 4 1 3 5")) == 5);
    RandomStream random(1, "distance");
    for (const Representation& each : {bits_of_5, two_reals, order_of_6})
        for (int i = 0; i < 100; ++i) {
            Genome a = each.random(random), b = each.random(random);
            CHECK(each.distance(a, b) == doctest::Approx(each.distance(b, a)));
            CHECK(each.distance(a, a) == 0);
        }
}

TEST_CASE("empty representations and reversed bounds are refused") {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    CHECK_THROWS_WITH_AS(BitString(0), "the binary string has 0 bits, expected at least 1", std::invalid_argument);
    CHECK_THROWS_AS(Permutation(0), std::invalid_argument);
    CHECK_THROWS_AS(RealVector(0, {0, 1}), std::invalid_argument);
    CHECK_THROWS_WITH_AS(RealVector({{0, 1}, {5, -5}}),
                         "parameter 1: the range is 5 to -5, expected two finite numbers, the lower number first",
                         std::invalid_argument);
    CHECK_THROWS_WITH_AS(RealVector({{-1.5e308, 1.5e308}}),
                         "parameter 0: the width of the range -1.5e+308 to 1.5e+308 is beyond the range of a double",
                         std::invalid_argument);
    for (RealRange range : {RealRange{0, infinite}, RealRange{std::nan(""), 1}, RealRange{1, 1}})
        CHECK_THROWS_AS(RealVector({range}), std::invalid_argument);
}

TEST_CASE("a whole parameter is rounded down, whether bits or a real number code it") {
    ParameterField delay{.low = 1, .high = 5, .bits = 2, .whole = true}; // Table 5.1
    for (std::uint64_t code = 0; code < 4; ++code)
        CHECK(delay.value(code) == static_cast<double>(code + 1));
    ParameterField die{.low = 1, .high = 7, .bits = 4, .whole = true};
    std::map<double, int> seen;
    for (std::uint64_t code = 0; code < 16; ++code)
        ++seen[die.value(code)];
    CHECK(seen.size() == 6);
    CHECK(seen.begin()->first == 1);
    CHECK(seen.rbegin()->first == 6);
    CHECK(die.rounded(6.9) == 6);
    CHECK(die.rounded(7) == 6); // no code stands for 7
    CHECK(ParameterField{.low = 1, .high = 7, .bits = 4}.rounded(6.9) == 6.9);
    CHECK(ParameterCoding({delay, {-2, 2, 6}}).reals().range(1).high == 2);
}
