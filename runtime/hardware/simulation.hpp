#pragma once

#include "runtime/channel.hpp"
#include "runtime/deadlock.hpp"
#include "runtime/hardware/link.hpp"
#include "runtime/hardware/multiplexer.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/kernel.hpp"
#include "runtime/process.hpp"

#include <list>
#include <optional>
#include <string>

namespace placedpar {

/// How a run ended, and when.
struct RunResult {
    Ending ending;
    Time time; ///< virtual time at the end
    std::uint64_t fingerprint;
    std::optional<Deadlock> deadlock; ///< when processes are left that nothing will wake
};

/// A machine and the processes on it, to be run once.
///
///     Simulation simulation;
///     Channel<int> c("c");
///     simulation.process("sender", [&] { c.out().output(42); });
///     simulation.process("receiver", [&] { c.in().input(); });
///     RunResult result = simulation.run();
class Simulation {
public:
    Processor& processor(std::string name, std::int64_t clock_hz = 20'000'000, Cycles channel_call = Cycles{0}) {
        return processors_.emplace_back(kernel_, std::move(name), clock_hz, channel_call);
    }
    Link& link(const LinkTiming& timing = {}) { return links_.emplace_back(kernel_, timing); }
    /// Virtual channels over a link. Null processors are infinitely fast.
    Multiplexer& multiplexer(const std::string& name, Link& over, Processor* a, Processor* b) {
        return multiplexers_.emplace_back(kernel_, name, over, a, b);
    }
    /// A process that starts when the simulation does; on no processor it takes no time.
    Process& process(std::string name, Process::Body body, Processor* on = nullptr, Priority priority = Priority::low) {
        Process& process = processes_.emplace_back(kernel_, std::move(name), std::move(body), on, priority);
        kernel_.make_ready(process);
        return process;
    }

    /// Another of the program's possible courses: see Kernel::shuffle.
    void shuffle(std::uint64_t seed) { kernel_.shuffle(seed); }
    /// Runs until every process has ended, nobody can go on, or the limit is reached. Rethrows what a
    /// process threw; throws std::overflow_error when it would go on beyond the end of virtual time.
    /// REQUIRES: called once; no other simulation is running on this thread.
    RunResult run(Time limit = Time::max()) {
        std::optional<Deadlock> deadlock;
        Ending ending = kernel_.run(limit, [&](Ending e) {
            if (e == Ending::stuck)
                deadlock = find_deadlock(kernel_);
        });
        return {ending, kernel_.now(), kernel_.fingerprint().value(), std::move(deadlock)};
    }
    /// Ends a run that is under way. May be called from a signal handler or another thread.
    void interrupt() { kernel_.interrupt(); }

    /// REQUIRES: before run(); the sink outlives it.
    void trace_to(TraceSink& sink) { kernel_.trace_to(sink); }

    const std::list<Processor>& processors() const { return processors_; }
    const std::list<Link>& links() const { return links_; }
    const std::list<Process>& processes() const { return processes_; }

private:
    Kernel kernel_;
    std::list<Processor> processors_;
    std::list<Link> links_;
    std::list<Multiplexer> multiplexers_;
    std::list<Process> processes_;
};

} // namespace placedpar
