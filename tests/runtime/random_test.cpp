#include "runtime/random.hpp"
#include "tests/runtime/each_vector_width.hpp"

#include <doctest/doctest.h>

#include <array>
#include <vector>

using namespace placedpar;

TEST_CASE("a random stream depends only on seed and path") {
    RandomStream a(1, "cluster[0].master"), b(1, "cluster[0].master"), c(1, "cluster[1].master"),
        d(2, "cluster[0].master");
    auto first = a();
    CHECK(b() == first);
    CHECK(c() != first);
    CHECK(d() != first);
}

TEST_CASE("Philox 4x32-10 gives the known answer of Random123's kat_vectors for key 0 and counter 0") {
    r123::Philox4x32 philox;
    auto block = philox({{0, 0, 0, 0}}, {{0, 0}});
    CHECK(block[0] == 0x6627e8d5);
    CHECK(block[1] == 0xe169c58d);
    CHECK(block[2] == 0xbc57ac4c);
    CHECK(block[3] == 0x9b00dbd8);
}

TEST_CASE("fill() gives the numbers of single calls, from any position in a block") {
    for (std::size_t before : {0u, 1u, 5u, 63u, 64u, 65u})
        for (std::size_t count : {0u, 1u, 2u, 63u, 64u, 65u, 200u}) {
            RandomStream one(3, "fill"), all(3, "fill");
            std::array<std::uint32_t, 200> numbers{};
            for (std::size_t i = 0; i < before; ++i)
                CHECK(one() == all());
            all.fill(std::span(numbers).first(count));
            for (std::size_t i = 0; i < count; ++i)
                REQUIRE(numbers.at(i) == one());
            REQUIRE(all() == one());
        }
}

TEST_CASE("a stream's numbers are Random123's, block after block, in every vector width") {
    const r123::Philox4x32::key_type key{{0x89abcdef, 0x01234567}};
    std::vector<std::uint32_t> expected;
    // The hash of the empty path is the offset basis of FNV-1a with 64 bits.
    for (std::uint32_t block = 0; block < 100; ++block)
        for (std::uint32_t number : r123::Philox4x32{}({{block, 0, 0x84222325, 0xcbf29ce4}}, key))
            expected.push_back(number);
    test::in_each_vector_width([&] {
        RandomStream stream(0x0123456789abcdef, "");
        std::vector<std::uint32_t> drawn(expected.size());
        for (std::uint32_t& number : drawn)
            number = stream();
        CHECK(drawn == expected);
    });
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

TEST_CASE("a stream can go to any of its numbers") {
    RandomStream whole(3, "path");
    std::vector<RandomStream::result_type> numbers(1000);
    whole.fill(numbers);
    CHECK(whole.drawn() == numbers.size());
    for (const std::uint64_t drawn : {0u, 1u, 3u, 4u, 63u, 64u, 65u, 127u, 500u, 999u}) {
        RandomStream stream(3, "path");
        stream();
        stream.go_to(drawn);
        CHECK(stream.drawn() == drawn);
        CHECK(stream() == numbers[drawn]);
        CHECK(stream.drawn() == drawn + 1);
    }
    RandomStream far(3, "path"), farther(3, "path"); // beyond 2^32 blocks
    far.go_to(0x4'0000'0003u);
    farther.go_to(0x4'0000'0000u);
    std::array<RandomStream::result_type, 4> block;
    farther.fill(block);
    CHECK(far() == block[3]);
    CHECK(farther.drawn() == 0x4'0000'0004u);
}
