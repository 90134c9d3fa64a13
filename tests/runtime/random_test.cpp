#include "runtime/random.hpp"

#include <doctest/doctest.h>

#include <array>

using namespace placedpar;

TEST_CASE("a stream depends on seed and path alone") {
    RandomStream a(1, "cluster[0].master"), b(1, "cluster[0].master"), c(1, "cluster[1].master"),
        d(2, "cluster[0].master");
    auto first = a();
    CHECK(b() == first);
    CHECK(c() != first);
    CHECK(d() != first);
}

TEST_CASE("Philox 4x32-10 gives the known answer of Random123's kat_vectors for key 0, counter 0") {
    r123::Philox4x32 philox;
    auto block = philox({{0, 0, 0, 0}}, {{0, 0}});
    CHECK(block[0] == 0x6627e8d5);
    CHECK(block[1] == 0xe169c58d);
    CHECK(block[2] == 0xbc57ac4c);
    CHECK(block[3] == 0x9b00dbd8);
}

TEST_CASE("filling takes the numbers that so many calls would give, from any place in a block") {
    for (std::size_t before = 0; before < 5; ++before)
        for (std::size_t count = 0; count < 14; ++count) {
            RandomStream one(3, "fill"), all(3, "fill");
            std::array<std::uint32_t, 14> numbers{};
            for (std::size_t i = 0; i < before; ++i)
                CHECK(one() == all());
            all.fill(std::span(numbers).first(count));
            for (std::size_t i = 0; i < count; ++i)
                REQUIRE(numbers.at(i) == one());
            REQUIRE(all() == one());
        }
}

TEST_CASE("below(n) is uniform over 0 ... n - 1") {
    RandomStream stream(7, "dice");
    std::array<int, 6> seen{};
    constexpr int throws = 60000;
    for (int i = 0; i < throws; ++i)
        ++seen.at(stream.below(6));
    double chi_squared = 0;
    for (int count : seen)
        chi_squared += (count - throws / 6.0) * (count - throws / 6.0) / (throws / 6.0);
    CHECK(chi_squared < 20.5); // 5 degrees of freedom, 99.9 %
}
