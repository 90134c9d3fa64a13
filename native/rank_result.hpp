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

/// An exception that a rank threw, as reported to rank 0.
struct RankFailure {
    Time time{};           ///< when a process threw it; Time::max() if it did not come from a process
    bool is_defect = true; ///< false if a user can be the cause
    std::string text;
};

/// The data that a rank sends to rank 0 at the end of a run.
struct RankResult {
    RunPart part;
    std::vector<StuckChannel>
        ends; ///< the channels to other ranks, without the user of the other end, which this rank does not know
    std::optional<RankFailure> failure;
    Notices notices;                  ///< empty unless the run is recorded
    std::chrono::nanoseconds begun{}; ///< when the rank began, by its own clock
};

MessageBytes packed(const RankResult&);
/// Unpacks a result. Throws NoMessage if the bytes are not a packed result.
RankResult rank_result_from(std::span<const std::uint8_t>);

/// Joins the deadlocks of all ranks into one, and finds a wait cycle that leads over several ranks. Returns nothing if
/// no rank is stuck.
std::optional<Deadlock> join_deadlocks(const std::vector<RankResult>&, const Network&);

} // namespace placedpar::native
