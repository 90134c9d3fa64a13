#pragma once

#include "observe/trace/path_part.hpp"
#include "observe/trace/tracks.hpp"
#include "runtime/time.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace placedpar {

/// A channel, and the process that came to its other end, or has to come.
struct Awaited {
    std::string channel;
    std::string partner; ///< "" where none ever used the channel
};

/// An interval in which the same goes on on a track: a processor executes, a link carries, a process does the rest.
/// The intervals of one track do not overlap and come in order.
struct Slice {
    std::size_t track;
    Activity activity;
    Time begin, end;                   ///< begin < end, unless it is open
    bool open;                         ///< it goes on when the trace ends
    std::string subject = {};          ///< the process that is executed; the channel that is carried
    std::uint64_t bytes = 0;           ///< that were carried; of an open slice not known
    std::vector<Awaited> awaited = {}; ///< channels of a wait
    bool awaits_timer = false;
};

/// A message on its way: it leaves within a slice of one track, and arrives at or after that within one of another.
struct MessageArrow {
    const std::string& channel;
    std::size_t from, to;
    Time left, arrived;
};

/// Writes a trace in some format.
class TraceWriter {
public:
    virtual ~TraceWriter() = default;
    virtual void write(const Slice&) = 0;
    /// Both of its slices have been written.
    virtual void write(const MessageArrow&) = 0;
    /// The critical path, where it is known, in order of time; before finish(). What a format has no means for is left
    /// out.
    virtual void draw_path(std::span<const PathPart>) {}
    /// The trace covers the time from `begin` to `end`; `why` says what happened then: "deadlock".
    virtual void finish(Time begin, Time end, const std::string& why) = 0;
};

} // namespace placedpar
