#pragma once

#include "netlist/network/network.hpp"
#include "runtime/event.hpp"
#include "runtime/executive.hpp"
#include "runtime/process.hpp"

#include <chrono>
#include <cstddef>
#include <deque>
#include <map>
#include <string>
#include <unordered_map>

namespace placedpar {
class Kernel;
} // namespace placedpar

namespace placedpar::native {

/// Executes the processes of one kernel of a native run at the pace of the netlist's processors: a computation takes
/// the time that its cycles take on the process's processor, divided by the pace. The kernel waits until this time is
/// over, so processes of other processors continue meanwhile. The time that the computation really takes on this
/// computer is part of it. If a process computes repeatedly without a wait, lateness does not accumulate.
///
/// A processor does one computation at a time, in the order in which its processes begin them. Meanwhile its other
/// processes can communicate. Channels, PAR, ALT and timers are not slowed down. All processors of a kernel are one
/// executive, so that channels between these processors need no carrier.
class Pace final : public Executive {
public:
    /// REQUIRES: pace > 0; the kernel outlives this object.
    Pace(Kernel&, const Network&, double pace);

    Time tick(Priority) const override { return std::chrono::microseconds{1}; }
    bool begin_computing(Process&, Cycles, const CodeShape&) override;
    void make_ready(Process&) override;
    void leave(Process&, Process* successor) override;

private:
    struct Computation {
        Process* process;
        Time takes;
    };
    struct Processor final : Event {
        Processor(Kernel& run_by, Time of_a_cycle) : kernel(run_by), cycle(of_a_cycle) {}
        void happen() noexcept override;
        void begin_first();
        Kernel& kernel;
        Time cycle;                             ///< zero if computations take no time
        std::deque<Computation> computations{}; ///< the first is under way
        Time until{};                           ///< end of the last computation that has begun
        const Process* last = nullptr;          ///< the process of the last computation, if it has not waited since
    };
    Processor& processor_of(const Process&);

    Kernel& kernel_;
    std::map<std::size_t, Processor> processors_;            ///< by index of the node
    std::unordered_map<std::string, Processor*> of_process_; ///< by the name of a process at the outermost level
};

} // namespace placedpar::native
