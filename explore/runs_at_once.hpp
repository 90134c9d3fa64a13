#pragma once

#include "explore/netlist_run.hpp"

#include <cstddef>
#include <functional>

namespace placedpar {

/// Does pieces of work, numbered from 0, in parallel on all cores, and returns when all have ended. `work` must pass
/// its interruption to its run: an interruption then ends the current runs, and no further piece begins. `done` is
/// called from time to time, in the caller's thread, with the number of ended pieces. Rethrows an exception of a piece
/// after all pieces have ended.
void run_at_once(std::size_t pieces, const std::function<void(std::size_t piece, Interruption&)>& work,
                 const Interruption& interruption, const std::function<void(std::size_t done)>& done);

} // namespace placedpar
