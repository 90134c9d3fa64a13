#pragma once

#include "tests/runtime/small_world.hpp"

#include <cstddef>
#include <functional>
#include <string>

namespace placedpar::test {

/// Which worlds there are.
struct Bounds {
    std::size_t longest;     ///< actions of a process
    bool polls = false;      ///< alternations with a SKIP, too
    bool any_guards = false; ///< an alternation is on any channels that come to the process, not on all of them
};

/// Hands every world within the bounds to `check`, once: all networks, all programs. Worlds that differ only in the
/// names of processes and channels are one, and so are worlds that differ only in actions that no course reaches: a
/// process has a further action only if some course leads to it. Every channel is one that a process outputs to or
/// inputs from, and every alternation has a guard.
///
/// REQUIRES: longest <= 15.
void for_every_world(const Bounds&, const std::function<void(const SmallWorld&)>& check);

/// Returns a text that is equal for all worlds that differ only in the names of processes and channels.
std::string text_of_its_kind(const SmallWorld&);

} // namespace placedpar::test
