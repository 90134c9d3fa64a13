#pragma once

#include "native/notice_log.hpp"
#include "netlist/network/network.hpp"
#include "netlist/run_report.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace placedpar {

/// Records what the processes of a native run do, on all its threads or ranks. After the run, passes the record to a
/// trace sink, as a simulated run would. (In a native run the processes run in real time.)
class NativeTrace {
public:
    /// The largest number of notices of a run (our choice; they take 200 Mbyte of memory). Each wait and each message
    /// makes two notices.
    static constexpr std::size_t most_notices = 8'000'000;

    /// Records nothing after `until`, and at most `most` notices of a run.
    explicit NativeTrace(Time until = Time::max(), std::size_t most = most_notices) : until_(until), most_(most) {}

    // The next three functions are called by the functions that make native runs.
    Time until() const { return until_; }
    /// Returns the largest number of notices of each thread or rank.
    std::size_t most_of(std::size_t places) const { return most_ / places; }
    /// Stores the notices of all threads or ranks. `noun` is "thread" or "rank". REQUIRES: all times are of the same
    /// clock.
    void set(std::string noun, std::vector<native::Notices>);

    /// Passes all notices to the sink, in order of time. The processes are on processors with the names "thread 0",
    /// "thread 1", ... or "rank 0", "rank 1", ...
    void replay(const Network&, TraceSink&) const;
    /// Returns a text that tells the user which part of the record is missing; "" if it is complete.
    std::string warning() const;

private:
    const native::Notices* first_full() const;
    std::string why_full() const;

    Time until_;
    std::size_t most_;
    std::string noun_;
    std::vector<native::Notices> of_places_;
};

/// Returns the network with the threads or ranks of a native run in place of the processors, without wires, so that
/// reports can name them. `run`: the report of the run.
Network with_places(Network, const RunReport& run);

} // namespace placedpar
