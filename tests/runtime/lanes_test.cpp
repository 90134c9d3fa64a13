// Tests that operations on eight numbers at once give the bits of single operations, in every vector width.

#include "runtime/lanes.hpp"
#include "runtime/random.hpp"
#include "tests/runtime/each_vector_width.hpp"

#include <doctest/doctest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

using namespace placedpar;

namespace {

using Eight = std::array<double, 8>;

Eight some_numbers(RandomStream& random) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr std::array<double, 8> special{0, -0.0,   infinity, -infinity, std::numeric_limits<double>::quiet_NaN(),
                                            1, 5e-324, 1e308};
    Eight numbers{};
    for (double& number : numbers)
        number = random.below(3) ? 2000 * random.uniform() - 1000 : special.at(random.below(8));
    return numbers;
}

/// Compares numbers by their bits, but takes all NaNs as equal. No standard states which NaN an operation returns.
bool same(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b));
}

/// Checks a formula for doubles and for Lanes.
template <class Formula>
void check(const char* name, const Formula& formula) {
    CAPTURE(name);
    RandomStream random(1, name);
    for (int i = 0; i < 500; ++i) {
        const Eight a = some_numbers(random), b = some_numbers(random);
        test::in_each_vector_width([&] {
            Eight together{};
            in_vectors([&]<std::size_t width>() { together = formula(Lanes<width>(a), Lanes<width>(b)).numbers(); });
            for (std::size_t lane = 0; lane < together.size(); ++lane)
                REQUIRE(same(together[lane], formula(a[lane], b[lane])));
        });
    }
}

} // namespace

TEST_CASE("arithmetic of eight lanes gives the bits of single doubles") {
    check("sum", [](const auto& a, const auto& b) { return a + b; });
    check("difference", [](const auto& a, const auto& b) { return a - b; });
    check("product", [](const auto& a, const auto& b) { return a * b; });
    check("quotient", [](const auto& a, const auto& b) { return a / b; });
    check("product and sum are rounded one by one", [](const auto& a, const auto& b) { return a * b + a; });
    check("a number for all lanes", [](const auto& a, const auto&) { return -0.0 + (3.7 * a - 1 / a); });
    check("in place", [](auto a, const auto& b) {
        a += b;
        a *= b;
        a -= 2.0;
        return -a;
    });
}

TEST_CASE("functions of eight lanes give the bits of single doubles") {
    using std::abs, std::sqrt, std::max, std::min, std::sin, std::cos, std::exp, std::log;
    check("max", [](const auto& a, const auto& b) { return max(a, b); });
    check("min", [](const auto& a, const auto& b) { return min(a, b); });
    check("abs", [](const auto& a, const auto&) { return abs(a); });
    check("sqrt", [](const auto& a, const auto&) { return sqrt(a); });
    check("sin, cos", [](const auto& a, const auto& b) { return sin(a) + cos(b); });
    check("exp, log", [](const auto& a, const auto& b) { return exp(a) + log(b); });
}

TEST_CASE("a vector width that the processor does not have is refused") {
    CHECK_THROWS_WITH_AS(use_vector_width(3), doctest::Contains("a vector width of 3 doubles, expected 2, 4 or 8"),
                         std::invalid_argument);
    CHECK_THROWS_AS(use_vector_width(16), std::invalid_argument);
    CHECK(vector_width() == widest_vector_width());
}
