#pragma once

#include "tests/runtime/small_world.hpp"

#include <cstddef>
#include <functional>
#include <string>

namespace placedpar::test {

/// Limits of the worlds to generate.
struct Bounds {
    std::size_t longest;     ///< largest number of actions of a process
    bool polls = false;      ///< includes alternations with SKIP
    bool any_guards = false; ///< true: alternations may use any subset of the channels that lead to the process; false:
                             ///< all of them
    std::size_t most_in_all = 45; ///< largest number of actions of all processes
};

/// Calls `check` once for every world within the bounds, with all networks and all programs. Worlds that differ only in
/// the names of processes and channels count as one. Worlds that differ only in actions that no execution reaches also
/// count as one: a process gets a further action only if an execution leads to it. Every channel has an end that a
/// process uses, and every alternation has a guard. REQUIRES: longest <= 15.
void for_every_world(const Bounds&, const std::function<void(const SmallWorld&)>& check);

/// Returns the same text for all worlds that differ only in the names of processes and channels.
std::string text_of_its_kind(const SmallWorld&);

} // namespace placedpar::test
