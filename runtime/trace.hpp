#pragma once

#include "runtime/process.hpp"
#include "runtime/time.hpp"

#include <cstdint>
#include <string>

namespace placedpar {

/// A place begins to be used: a direction of a link by a channel, or a bus or a device's track by its current subject.
struct PlaceTaken {
    const std::string& place;
    const std::string& subject;          ///< the channel, what the bus carries, or a master that waits for the bus
    Time since;                          ///< may lie in the future
    const AnyChannel* channel = nullptr; ///< the channel, if the place is a direction of a link
};

/// The use of a place ends.
struct PlaceLeft {
    const std::string& place;
    Time until;                         ///< may lie in the future
    std::uint64_t bytes = 0;            ///< bytes that a link carried without a break
    const Process* moves_for = nullptr; ///< the process that had the bus to itself, if any
    Time since{};                       ///< when `moves_for` got the bus to itself
};

/// The log of a run: each process and each place does one thing from one notice on until the next. The calls come while
/// the run goes on; a sink must change nothing.
///
/// 1. Notices come in the order of their times. An operation that takes no time begins and ends with two notices of the
///    same time.
/// 2. Processes, channels and their data may be destroyed after the call; processes that wait exist until they
///    continue.
class TraceSink {
public:
    /// From a moment on a process does something else:
    ///   starting          the process exists from now on; its program begins when it has its turn. Only `ready` may
    ///                     have been told of it before;
    ///   delayed, ...      it waits, as its activity and awaited_channels() say;
    ///   ready             what it waits for has come, or it has computed as long as it wanted to, or has lost its
    ///                     executive. Not said at the end of a PAR, nor when a delay takes no wait;
    ///   executing         a wait is over and its program runs again; activity and awaited_channels() are still those
    ///                     of the wait;
    ///   computing         its executive works for it. That may begin while its wait is not over yet, when the
    ///                     process is ready and its processor already spends time on it;
    ///   moving            it computes by moving words over a bus, the waiting for it included;
    ///   ended             its last notice.
    virtual void turns(const Process&, Activity, Time) = 0;
    /// A message is transferred from the channel's outputter to its inputter.
    virtual void communicated(const AnyChannel&, Time) = 0;
    virtual void takes(const PlaceTaken&, Time now) = 0;
    virtual void leaves(const PlaceLeft&, Time now) = 0;
    /// The work is over; the remaining processes are still in their waits. No notice follows.
    virtual void over(Time) = 0;

protected:
    ~TraceSink() = default;
};

} // namespace placedpar
