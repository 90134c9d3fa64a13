#pragma once

#include "explore/netlist_run.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace placedpar {

// Before a command makes a very large number of runs, the user must confirm it.

constexpr std::uint64_t most_unasked = 10'000; ///< largest number of runs that begin without a question

/// The runs that are about to start.
struct RunsAhead {
    std::uint64_t runs;
    bool exact; ///< if false, `runs` is an upper limit
    std::size_t at_once;
    std::optional<double> seconds_a_run; ///< time per run, if known
};

/// States the number of runs and their total time, and asks whether to begin. Returns false if the user does not
/// confirm, or if an interruption is requested meanwhile. Throws UserError if standard input or standard error is not a
/// terminal, so that the question cannot be asked.
bool are_meant(const RunsAhead&, const Interruption&);

/// Returns "3 days" or "4 min", for example.
std::string print_duration(double seconds);
/// Returns "1,000,000", for example.
std::string print_count(std::uint64_t count);

} // namespace placedpar
