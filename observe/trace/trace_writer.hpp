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

/// A channel for which a process waits, and the partner: the process that uses the channel's other end.
struct Awaited {
    std::string channel;
    std::string partner; ///< "" if no process ever used the other end
};

/// An interval in which a track (the timeline of a processor, process, link or bus) has one activity. Processors
/// execute, links carry, and processes have the other activities. The slices of a track do not overlap and come in
/// order.
struct Slice {
    std::size_t track;
    Activity activity;
    Time begin, end;                   ///< begin < end, unless the slice is open
    bool open;                         ///< the activity still continues at the end of the trace
    std::string subject = {};          ///< process that is executed, or channel that is carried
    std::uint64_t bytes = 0;           ///< number of bytes carried; not yet known for an open slice
    std::vector<Awaited> awaited = {}; ///< channels of a wait
    bool awaits_timer = false;
};

/// A message. It leaves within a slice of one track, and arrives at the same time or later within a slice of another
/// track.
struct MessageArrow {
    const std::string& channel;
    std::size_t from, to;
    Time left, arrived;
};

/// Base class of the writers of trace formats. Timeline calls their functions.
class TraceWriter {
public:
    virtual ~TraceWriter() = default;
    virtual void write(const Slice&) = 0;
    /// REQUIRES: both slices of the message have been written.
    virtual void write(const MessageArrow&) = 0;
    /// Adds the critical path, in order of time. Call this function before finish(), if the path is known. A format may
    /// ignore the path.
    virtual void draw_path(std::span<const PathPart>) {}
    /// Ends the trace, which covers the time from `begin` to `end`. `why` says why the trace ended, such as "deadlock".
    virtual void finish(Time begin, Time end, const std::string& why) = 0;
};

} // namespace placedpar
