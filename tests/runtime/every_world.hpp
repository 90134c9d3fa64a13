#pragma once

#include "tests/runtime/small_world.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace placedpar::test {

/// What a process can do with the ends of channels that it has.
std::vector<Action> alphabet(const SmallWorld&, std::size_t process, bool polls);

/// Every way to lay channels between three processes, but for the processes' names.
std::vector<SmallWorld> every_network(std::size_t channels);

/// Gives the processes of a network every sequence of at most `longest` actions, and hands the worlds to `check`.
/// Worlds that differ only in what no process ever comes to do are one: a sequence gets a further action where some
/// course leads to its end.
void for_every_program(SmallWorld network, std::size_t longest, bool polls,
                       const std::function<void(const SmallWorld&)>& check);

} // namespace placedpar::test
