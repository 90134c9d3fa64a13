#pragma once

#include "explore/netlist_run.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace placedpar {

// Very many runs are begun only if the user means them.

constexpr std::uint64_t most_unasked = 10'000; ///< runs that are begun without a question

/// Runs that are about to be made.
struct RunsAhead {
    std::uint64_t runs;
    bool exact; ///< else at most that many
    std::size_t at_once;
    std::optional<double> seconds_a_run; ///< where that is known
};

/// Says how many they are and how long they take, and asks whether to begin: not where nothing is answered, or the
/// interruption is requested meanwhile. Throws UserError where nobody can be asked: standard input or standard error is
/// no terminal.
bool are_meant(const RunsAhead&, const Interruption&);

/// "3 days", "4 min".
std::string print_duration(double seconds);
/// "1,000,000".
std::string print_count(std::uint64_t count);

} // namespace placedpar
