#include "problems/plant/pseudo_random_bits.hpp"

#include <doctest/doctest.h>

#include <set>
#include <vector>

using namespace placedpar;

namespace {

std::vector<int> signs(std::size_t count, std::size_t start = 0) {
    PseudoRandomBits bits(start);
    std::vector<int> signs;
    while (signs.size() < count)
        signs.push_back(bits.next() ? 1 : -1);
    return signs;
}

} // namespace

TEST_CASE("every seven bits except zeros occur once in a period of 127") {
    PseudoRandomBits bits;
    std::set<unsigned> seen;
    unsigned last = 0;
    for (std::size_t i = 0; i < 6 + PseudoRandomBits::period; ++i) {
        last = ((last << 1) | (bits.next() ? 1u : 0u)) & 0x7f;
        if (i >= 6)
            seen.insert(last);
    }
    CHECK(seen.size() == PseudoRandomBits::period);
    CHECK(!seen.contains(0));
}

TEST_CASE("a sequence and its shifted copy agree in one bit fewer than they differ") {
    constexpr int period = PseudoRandomBits::period;
    auto sequence = signs(2 * PseudoRandomBits::period);
    for (int shift = 0; shift < period; ++shift) {
        int correlation = 0;
        for (int i = 0; i < period; ++i)
            correlation += sequence[static_cast<std::size_t>(i)] * sequence[static_cast<std::size_t>(i + shift)];
        CHECK(correlation == (shift == 0 ? period : -1));
    }
}

TEST_CASE("pseudo random bits start at the given position") {
    auto sequence = signs(60);
    CHECK(signs(50, 10) == std::vector<int>(sequence.begin() + 10, sequence.end()));
}
