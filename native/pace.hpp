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

/// Slows a native run, that is, a run in real time on this computer, down to `pace` times the speed of the simulated
/// machine. A computation takes the time of its cycles on the netlist's processor, divided by `pace`. The process waits
/// until this time is over, while processes of other processors continue. The time that the computation really takes on
/// this computer is included. If a process computes repeatedly without a wait, lateness does not accumulate.
///
/// A processor does one computation at a time, in the order in which its processes begin computations. Meanwhile its
/// other processes can communicate. Channels, PAR, ALT and timers are not slowed down. One object stands for all
/// processors whose processes run on one thread. So channels between these processors need no carrier, such as a link.
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
