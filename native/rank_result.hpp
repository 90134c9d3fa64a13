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

/// Tells rank 0 about an exception that a rank has thrown.
struct RankFailure {
    Time time{};           ///< when a process has thrown it; Time::max() if no process has
    bool is_defect = true; ///< false: a user can be the cause
    std::string text;
};

/// What a rank tells rank 0 at the end of a run.
struct RankResult {
    RunPart part;
    std::vector<StuckChannel> ends; ///< the channels to other ranks; of the other end the rank knows no user
    std::optional<RankFailure> failure;
    Notices notices;                  ///< of a recorded run
    std::chrono::nanoseconds begun{}; ///< when the rank has begun, by its own clock
};

MessageBytes packed(const RankResult&);
/// Throws NoMessage.
RankResult rank_result_from(std::span<const std::uint8_t>);

/// Joins the deadlocks of all ranks into one, with the wait cycle over ranks; nothing if no rank is stuck.
std::optional<Deadlock> join_deadlocks(const std::vector<RankResult>&, const Network&);

} // namespace placedpar::native
