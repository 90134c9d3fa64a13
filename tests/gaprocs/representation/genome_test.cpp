#include "gaprocs/representation/genome.hpp"
#include "runtime/random.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

using namespace placedpar;

namespace {

/// Returns the last `length` binary digits of the number.
std::string digits(std::uint64_t number, std::size_t length) {
    std::string text;
    for (std::size_t i = length; i-- > 0;)
        text += (number >> i) & 1u ? '1' : '0';
    return text;
}

std::string random_text(std::size_t length, RandomStream& random) {
    std::string text;
    for (std::size_t i = 0; i < length; ++i)
        text += random.chance(0.5) ? '1' : '0';
    return text;
}

} // namespace

TEST_CASE("bit 0 is the leftmost character") {
    Genome genome = Genome::from_string("0110");
    CHECK(genome.size() == 4);
    CHECK_FALSE(genome.bit(0));
    CHECK(genome.bit(1));
    CHECK(genome.field(0, 4) == 6);
    CHECK(genome.to_string() == "0110");
    genome.flip(0);
    genome.set(2, false);
    CHECK(genome.to_string() == "1100");
    CHECK(genome.words()[0] == 0xC000000000000000u);
}

TEST_CASE("every field of every string up to 8 characters is its binary number") {
    for (std::size_t length = 1; length <= 8; ++length)
        for (std::uint64_t number = 0; number < (1u << length); ++number) {
            std::string text = digits(number, length);
            Genome genome = Genome::from_string(text);
            REQUIRE(genome.to_string() == text);
            for (std::size_t first = 0; first < length; ++first)
                for (std::size_t count = 1; first + count <= length; ++count)
                    REQUIRE(genome.field(first, count) == std::stoull(text.substr(first, count), nullptr, 2));
        }
}

TEST_CASE("fields of up to 64 bits may cross word boundaries") {
    RandomStream random(3, "fields");
    for (int i = 0; i < 5000; ++i) {
        std::size_t length = 1 + random.below(200);
        std::string text = random_text(length, random);
        Genome genome = Genome::from_string(text);
        std::size_t first = random.below(static_cast<std::uint32_t>(length));
        std::size_t count = 1 + random.below(static_cast<std::uint32_t>(std::min<std::size_t>(64, length - first)));
        std::uint64_t value = std::stoull(text.substr(first, count), nullptr, 2);
        REQUIRE(genome.field(first, count) == value);
        Genome rebuilt = Genome::from_string(text.replace(first, count, std::string(count, '0')));
        rebuilt.set_field(first, count, value);
        REQUIRE(rebuilt == genome);
    }
}

TEST_CASE("swap_leading exchanges the leading characters as in thesis eq. 1.1 and 1.2") {
    Genome a = Genome::from_string("0000000"), b = Genome::from_string("1111111");
    swap_leading(a, b, 4);
    CHECK(a.to_string() == "1111000");
    CHECK(b.to_string() == "0000111");
}

TEST_CASE("swap_leading exchanges the same characters as an exchange of text, at any length and cut") {
    RandomStream random(4, "exchange");
    for (std::size_t length : {1u, 2u, 10u, 63u, 64u, 65u, 128u, 150u})
        for (std::size_t cut = 0; cut <= length; ++cut) {
            std::string left = random_text(length, random), right = random_text(length, random);
            Genome a = Genome::from_string(left), b = Genome::from_string(right);
            swap_leading(a, b, cut);
            REQUIRE(a.to_string() == right.substr(0, cut) + left.substr(cut));
            REQUIRE(b.to_string() == left.substr(0, cut) + right.substr(cut));
        }
}

TEST_CASE("random strings have as many ones as zeros at every position, and zeros past the end") {
    RandomStream random(5, "random strings");
    constexpr int count = 4000;
    std::string::size_type length = 70;
    std::vector<int> ones(length);
    for (int i = 0; i < count; ++i) {
        Genome genome = Genome::random(length, random);
        REQUIRE(genome == Genome::from_string(genome.to_string())); // equality compares whole words
        for (std::size_t bit = 0; bit < length; ++bit)
            ones[bit] += genome.bit(bit);
    }
    for (int seen : ones)
        CHECK(std::abs(seen - count / 2) < 150); // 4.7 standard deviations
}

TEST_CASE("strings of different lengths are not equal") {
    CHECK(Genome::from_string("010") == Genome::from_string("010"));
    CHECK(Genome::from_string("010") != Genome::from_string("0100"));
    CHECK(Genome(10).bytes() == 2);
    CHECK(Genome(16).bytes() == 2);
    CHECK(Genome(17).bytes() == 3);
}

TEST_CASE("a string of other characters than 0 and 1 is refused") {
    CHECK_THROWS_WITH_AS(Genome::from_string("01x"),
                         "a binary string has only the characters 0 and 1: '01x' has 'x' at position 2",
                         std::invalid_argument);
}
