#pragma once

#include "native/notice_log.hpp"
#include "native/run_parts.hpp"
#include "runtime/byte_form.hpp"

#include <chrono>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace placedpar::native {

/// An exception in a rank (a copy of the program that mpirun started), as reported to rank 0.
struct RankFailure {
    Time time{};           ///< when a process threw it; Time::max() if no process threw it
    bool is_defect = true; ///< false if the user can be the cause
    std::string text;
};

/// What a rank sends to rank 0 at the end of a native run, for the report. A rank is a copy of the program, started by
/// mpirun, that runs some of the processes.
struct RankResult {
    RunPart part;
    std::vector<StuckChannel> ends; ///< the channels to other ranks, each with the user of its end in this rank
    std::optional<RankFailure> failure;
    Notices notices;                  ///< empty unless the run is recorded
    std::chrono::nanoseconds begun{}; ///< when the rank began, by its own clock
};

MessageBytes packed(const RankResult&);
/// Unpacks a result. Throws NoMessage if the bytes are not a packed result.
RankResult rank_result_from(std::span<const std::uint8_t>);

/// Joins the deadlock reports of all ranks into one, and finds a cycle of waiting processes, which may lead over
/// several ranks. Returns nothing if no rank is stuck.
std::optional<Deadlock> join_deadlocks(const std::vector<RankResult>&, const Network&);

} // namespace placedpar::native
