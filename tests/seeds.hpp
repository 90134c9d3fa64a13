#pragma once

#include "tests/sanitized.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>

#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <string>
#include <vector>

namespace placedpar::test {

/// Returns the value of the environment variable PLACEDPAR_SEED; null if it is not set.
inline const char* seed_asked_for() { return std::getenv("PLACEDPAR_SEED"); }

/// Returns whether a test runs all of its cases, so that it may judge the totals.
inline bool all_seeds() { return !sanitized && !seed_asked_for(); }

/// Returns the seeds of a random test: `count` of them, a tenth of them under sanitizers, or only the seed in
/// PLACEDPAR_SEED. With `INFO(test::replay(seed))`, a failing case prints the command that repeats it.
inline std::vector<std::uint64_t> seeds(std::size_t count, std::uint64_t first = 0) {
    if (const char* one = seed_asked_for())
        return {std::strtoull(one, nullptr, 10)};
    std::vector<std::uint64_t> all(sanitized ? (count + 9) / 10 : count);
    std::iota(all.begin(), all.end(), first);
    return all;
}

/// Returns "again: PLACEDPAR_SEED=17 build/release/tests/runtime/test_runtime -tc='random traffic ...'".
inline std::string replay(std::uint64_t seed) {
    const auto& options = *doctest::getContextOptions();
    std::string name = options.currentTest->m_name;
    for (char& each : name)
        if (each == ',' || each == '\'') // doctest ends a name at a comma; ? stands for any character
            each = '?';
    return fmt::format("again: PLACEDPAR_SEED={} {} -tc='{}'", seed, options.binary_name.c_str(), name);
}

} // namespace placedpar::test
