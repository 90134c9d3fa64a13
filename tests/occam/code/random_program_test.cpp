// Compiles random programs in all ways, runs them, and compares them with an interpreter.

#include "executed.hpp"
#include "random_program.hpp"
#include "tests/sanitized.hpp"
#include "tests/seeds.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <vector>

using namespace placedpar;
using namespace placedpar::test;

namespace {

/// Returns the ways to compile a program that has no errors, or one that has.
std::vector<occam::CodeOptions> ways(bool has_reals, bool has_error) {
    using transputer::Model;
    std::vector<occam::CodeOptions> all;
    for (const auto mode : {occam::ErrorMode::halt, occam::ErrorMode::stop, occam::ErrorMode::universal})
        all.push_back({.model = Model::t800, .mode = mode, .vector_space = mode != occam::ErrorMode::halt});
    if (!has_reals) {
        all.push_back({.model = Model::t414, .vector_space = true});
        all.push_back({.model = Model::t425, .mode = occam::ErrorMode::stop, .vector_space = false});
    }
    if (has_error)
        return all;
    all.push_back({.model = Model::t800, .range_checks = false});
    all.push_back({.model = Model::t800, .range_checks = false, .run_time_checks = false});
    if (!has_reals)
        all.push_back({.model = Model::t425, .range_checks = false, .run_time_checks = false, .vector_space = false});
    return all;
}

void check_random_program(std::uint64_t seed, std::size_t& errors) {
    const bool has_reals = seed % 3 != 0;
    const RandomProgram program(seed, has_reals);
    const RandomProgram::Outcome expected = program.interpreted();
    errors += expected.is_error;
    INFO(replay(seed), "\n", program.text);
    for (const occam::CodeOptions& options : ways(has_reals, expected.is_error)) {
        INFO(fmt::format("model {} mode {} range {} checks {} vector space {}", static_cast<int>(options.model),
                         static_cast<int>(options.mode), options.range_checks, options.run_time_checks,
                         options.vector_space));
        const Executed done = execute(program.text, options);
        REQUIRE(done.trouble == "");
        CHECK(done.halted == (expected.is_error && options.mode != occam::ErrorMode::stop));
        CHECK((done.results[1023] == 1) == !expected.is_error);
        REQUIRE(done.results[1022] >= 0);
        REQUIRE(done.results[1022] <= 900);
        CHECK(std::vector(done.results.begin(), done.results.begin() + done.results[1022]) == expected.log);
    }
}

} // namespace

TEST_CASE("random programs do what an interpreter does, compiled in every way") {
    std::size_t errors = 0;
    const std::size_t count = 20;
    for (const std::uint64_t seed : seeds(count))
        check_random_program(seed, errors);
    MESSAGE(errors);
    CHECK((errors < count / 2 || !all_seeds()));
}

TEST_CASE("a thousand random programs do what an interpreter does" * doctest::skip()) {
    const char* const asked = std::getenv("PLACEDPAR_COUNT");
    std::size_t errors = 0;
    for (const std::uint64_t seed : seeds(asked ? std::strtoul(asked, nullptr, 10) : 1000, 1000))
        check_random_program(seed, errors);
    MESSAGE(errors, " programs with errors");
}
