#pragma once

#include "native/notice_log.hpp"
#include "netlist/network/network.hpp"
#include "netlist/run_report.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace placedpar {

/// Records what the processes of a native run do, on all its threads or ranks, and tells it to a sink after the run.
class NativeTrace {
public:
    /// The most notices of a run, our choice: they take 200 Mbyte. A wait has two, and so has a message.
    static constexpr std::size_t most_notices = 8'000'000;

    /// Records nothing after `until`, and at most `most` notices of a run.
    explicit NativeTrace(Time until = Time::max(), std::size_t most = most_notices) : until_(until), most_(most) {}

    // The next functions are for runs.
    Time until() const { return until_; }
    /// Returns the most notices of each thread or rank.
    std::size_t most_of(std::size_t places) const { return most_ / places; }
    /// `noun`: what the threads or ranks are called. REQUIRES: all notices have times of one clock.
    void set(std::string noun, std::vector<native::Notices>);

    /// Tells the sink everything, in the order of time. The processes are named, and on the processors "thread 0",
    /// "thread 1", ... or "rank 0", ...
    void replay(const Network&, TraceSink&) const;
    /// Returns lines of text that tell the user what is missing; "" if nothing is.
    std::string warning() const;

private:
    const native::Notices* first_full() const;
    std::string why_full() const;

    Time until_;
    std::size_t most_;
    std::string noun_;
    std::vector<native::Notices> of_places_;
};

/// Returns the network of a native run: its threads or ranks stand in place of the nodes, without any wires. `run`: the
/// report of the run.
Network with_places(Network, const RunReport& run);

} // namespace placedpar
