#pragma once

#include "tests/runtime/small_world.hpp"

#include <cstddef>
#include <functional>
#include <string>

namespace placedpar::test {

/// Limits the worlds to generate.
struct Bounds {
    std::size_t longest;     ///< most actions of a process
    bool polls = false;      ///< includes alternations with a SKIP
    bool any_guards = false; ///< alternations may use any subset of the channels that lead to the process, not only all
                             ///< of them
};

/// Calls `check` once for every world within the bounds: all networks, all programs. Worlds that differ only in the
/// names of processes and channels count as one. So do worlds that differ only in actions that no execution reaches: a
/// process gets a further action only if an execution leads to it. Every channel is used by a process at some end, and
/// every alternation has a guard. REQUIRES: longest <= 15.
void for_every_world(const Bounds&, const std::function<void(const SmallWorld&)>& check);

/// Returns the same text for all worlds that differ only in the names of processes and channels.
std::string text_of_its_kind(const SmallWorld&);

} // namespace placedpar::test
