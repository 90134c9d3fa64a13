#pragma once

#include "explore/netlist_run.hpp"
#include "explore/workers.hpp"

#include <cstddef>
#include <functional>

namespace placedpar {

/// Executes pieces of work, such as simulation runs, in `at_once` threads, and returns when all have ended. Pieces are
/// numbered from 0. If `interruption` is requested, ends the current runs and begins no further piece. REQUIRES: `work`
/// passes its Interruption on to its run. `done` is called from time to time, in the caller's thread, with the number
/// of ended pieces. Rethrows an exception of a piece after all threads have ended.
void run_at_once(std::size_t pieces, const std::function<void(std::size_t piece, Interruption&)>& work,
                 const Interruption& interruption, const std::function<void(std::size_t done)>& done,
                 std::size_t at_once = count_cores());

} // namespace placedpar
