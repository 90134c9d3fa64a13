#pragma once

#include "explore/netlist_run.hpp"

#include <cstddef>
#include <functional>

namespace placedpar {

/// Does a number of pieces of work at once on all cores, each by its place from 0, and returns when they have ended.
/// An interruption ends the runs under way, to which each piece of work has to pass on the interruption that it is
/// given, and begins no others. `done` is told now and then, in the caller's thread, how many pieces have ended. Throws
/// what a piece of work throws, after all have ended.
void run_at_once(std::size_t pieces, const std::function<void(std::size_t piece, Interruption&)>& work,
                 const Interruption& interruption, const std::function<void(std::size_t done)>& done);

} // namespace placedpar
