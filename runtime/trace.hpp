#pragma once

#include "runtime/process.hpp"
#include "runtime/time.hpp"

#include <cstdint>
#include <string>

namespace placedpar {

/// Is told what happens in a run. It must change nothing.
///
/// 1. Notices come in the order of the moments that they are of. What an operation in no time would begin and end comes
///    as two notices of one moment.
/// 2. Processes, channels and what they refer to may be gone after the call; those that wait stay until they go on.
/// 3. A process has begun before anything else is said of it. It is ready from then on, except while it waits or
///    computes, until it ends.
class TraceSink {
public:
    virtual void began(const Process&, Time) = 0;
    /// As its activity and awaited_channels() say.
    virtual void waits(const Process&, Time) = 0;
    /// What it waits for has come, or it has begun: its program goes on when its executive gives it its turn. Not said
    /// of a process whose PAR has ended, and not when a delay takes no wait.
    virtual void made_ready(const Process&, Time) {}
    /// The wait is over and its program runs again; activity and awaited_channels() are still those of the wait.
    virtual void goes_on(const Process&, Time) = 0;
    virtual void computes(const Process&, Time) = 0;
    /// It has computed as long as it wanted to, or lost its executive.
    virtual void stops_computing(const Process&, Time) = 0;
    /// It computes by moving words over a bus, the waiting for it included, until it stops computing.
    virtual void moves(const Process& process, Time now) { computes(process, now); }
    /// The bus was its own since a moment, which may be that of moves() or later.
    virtual void moved(const Process&, const std::string& /* bus */, Time /* since */, Time /* now */) {}
    virtual void ended(const Process&, Time) = 0;

    /// A message is handed over, from the channel's outputter to its inputter.
    virtual void communicated(const AnyChannel&, Time) = 0;
    /// A direction of a link, by its name, carries bytes from the moment `since`, which may be still to come. They
    /// follow each other without a break.
    virtual void carries(const std::string& direction, const AnyChannel&, Time now, Time since) = 0;
    /// Of so many bytes the last is on the wire until the moment `until`, which may be still to come.
    virtual void carried(const std::string& direction, std::uint64_t bytes, Time now, Time until) = 0;

    /// A track of a bus, which is what it carries, or a master that waits for it, is the subject's from now on; it is
    /// nobody's again.
    virtual void occupied(const std::string& track, const std::string& subject, Time) = 0;
    virtual void vacated(const std::string& track, Time) = 0;

    /// The work is over; the processes that are left still stand where they wait. Nothing is said afterwards.
    virtual void over(Time) = 0;

protected:
    ~TraceSink() = default;
};

} // namespace placedpar
