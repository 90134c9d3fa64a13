#include "gaprocs/representation/coding.hpp"
#include "gaprocs/representation/genome.hpp"
#include "gaprocs/search_problem.hpp"
#include "runtime/random.hpp"
#include "tests/gaprocs/line_problem.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <array>
#include <bit>
#include <stdexcept>
#include <string>

using namespace placedpar;

TEST_CASE("the Gray code of three bits is 000, 001, 011, 010, 110, 111, 101, 100") {
    const std::array<const char*, 8> table{"000", "001", "011", "010", "110", "111", "101", "100"};
    for (std::uint64_t number = 0; number < 8; ++number) {
        Genome genome = Genome::from_string(table.at(number));
        CHECK(gray_code(number) == genome.field(0, 3));
        CHECK(gray_decoded(genome.field(0, 3)) == number);
        CHECK(GrayCoded(genome).field(0, 3) == number);
    }
}

TEST_CASE("Gray codes of neighbours differ in one bit, also where natural binary codes differ in many") {
    for (std::uint64_t number = 0; number < 4096; ++number)
        REQUIRE(std::popcount(gray_code(number) ^ gray_code(number + 1)) == 1);
    CHECK(std::popcount(gray_code(4095) ^ gray_code(0)) == 1); // the 12-bit code is cyclic
    CHECK(std::popcount(127u ^ 128u) == 8);                    // a Hamming cliff: at .0125, if 10 bits code 0 to .1
}

TEST_CASE("gray_decoded() is the inverse of gray_code() for numbers of up to 64 bits") {
    RandomStream random(1, "gray");
    for (int i = 0; i < 10'000; ++i) {
        std::uint64_t number = (std::uint64_t{random()} << 32 | random()) >> random.below(64);
        REQUIRE(gray_decoded(gray_code(number)) == number);
        REQUIRE(gray_code(gray_decoded(number)) == number);
    }
}

TEST_CASE("each field of a string is a Gray code of its own") {
    Genome genome = Genome::from_string("0110"
                                        "1000"
                                        "1");
    GrayCoded coded(genome);
    CHECK(coded.size() == 9);
    CHECK(coded.field(0, 4) == 4);
    CHECK(coded.field(4, 4) == 15);
    CHECK(coded.field(8, 1) == 1);
}

TEST_CASE("a problem that knows nothing of codings can be read in Gray code") {
    auto natural = make_search_problem(LineProblem{}), gray = make_search_problem(LineProblem{}, Coding::gray);
    CHECK(natural->coding() == Coding::natural);
    CHECK(gray->coding() == Coding::gray);
    CHECK(gray->coded(Coding::natural)->coding() == Coding::natural);
    auto record = line_record(3);
    for (std::uint64_t number = 0; number < 256; ++number) {
        Genome plain(8), coded(8);
        plain.set_field(0, 8, number);
        coded.set_field(0, 8, gray_code(number));
        REQUIRE(gray->decode(coded) == natural->decode(plain));
        REQUIRE(gray->decode(coded).at(0) == static_cast<double>(number) / 256);
        REQUIRE(gray->error(coded, record[1]) == natural->error(plain, record[1]));
        REQUIRE(gray->fitness(coded, record, 400) == natural->fitness(plain, record, 400));
    }
}

namespace {

/// A problem that counts ones and has no fields.
struct OnesProblem {
    std::size_t bits() const { return 8; }
    std::size_t channels() const { return 1; }
    double error(const Genome& genome, std::span<const double>) const { return decode(genome)[0]; }
    std::vector<double> decode(const Genome& genome) const {
        return {static_cast<double>(std::popcount(genome.field(0, 8)))};
    }
    std::vector<std::string> parameter_names() const { return {"ones"}; }
    std::vector<std::string> parameter_units() const { return {"1"}; }
};

} // namespace

TEST_CASE("a problem that does not read fields refuses the Gray code") {
    auto ones = make_search_problem(OnesProblem{});
    CHECK(ones->coded(Coding::natural)->decode(Genome::from_string("01100001")).at(0) == 3);
    CHECK_THROWS_WITH_AS(ones->coded(Coding::gray), doctest::Contains("does not divide its binary string into fields"),
                         UserError);
}
