#pragma once

#include "runtime/event.hpp"
#include "runtime/fingerprint.hpp"
#include "runtime/process.hpp"
#include "runtime/time.hpp"

#include <atomic>
#include <exception>
#include <memory>
#include <vector>

namespace placedpar {

class FiberScheduler;

/// Why a run ended. `stuck`: processes are left that nothing will ever wake.
enum class Ending { completed, stuck, time_limit, interrupted };

/// The heart of a simulation: who runs, and what time it is.
///
/// The rule: processes that are ready run in the order in which they became ready, each until it waits.
/// When nobody is ready, the earliest event of the future happens (time, then priority, then insertion) and
/// virtual time becomes that event's time. When nobody is ready and nothing is due, the run is over.
/// Nothing else decides, so a simulation is deterministic; it is also one thread, and does not watch the
/// wall clock.
///
/// Processes are Boost fibers. A fiber outlives its process and takes the next one, so that a PAR in a loop
/// costs no new stack.
class Kernel {
public:
    Kernel();
    ~Kernel();
    Kernel(const Kernel&) = delete;
    Kernel& operator=(const Kernel&) = delete;

    /// The kernel whose simulation this thread is running; null outside a run.
    static Kernel* current() { return current_; }

    Time now() const { return now_; }
    /// The process whose program is being executed. REQUIRES: called from within a process.
    Process& running() const { return *running_; }
    EventQueue& future() { return future_; }
    Fingerprint& fingerprint() { return fingerprint_; }
    /// A rank for one more wire, by which its events are ordered: wires are counted as they are created.
    std::uint64_t rank_of_new_wire() { return wires_++; }

    /// Lets a process go on: at once if it is not placed, else when its processor gets to it.
    void make_ready(Process&);
    /// To the back of the ready queue. For processors; everybody else calls make_ready.
    void enqueue(Process& p) { ready_.push_back(p); }
    /// Runs others until this process is made ready. Throws Unwinding when the simulation is over.
    /// REQUIRES: called from within a process.
    void wait();
    /// The same, but the process keeps its processor, as one that computes does.
    void give_way();
    /// Moves virtual time on to `until` if nobody else could do anything up to then and at that moment;
    /// returns whether it did. It is what waiting would come to, without the switch to and fro.
    bool pass_time(Time until);

    /// Runs until the end. Rethrows what a process threw. On return every process has been unwound.
    /// `at_end` is called before that, while the processes that are stuck still stand where they are.
    /// REQUIRES: no simulation is running on this thread; called once.
    Ending run(Time limit, const std::function<void(Ending)>& at_end);
    /// Ends the run at the next occasion. May be called from a signal handler.
    void interrupt() { interrupted_.store(true, std::memory_order_relaxed); }

    /// Every process of the program that exists and has not ended, in order of creation.
    std::vector<const Process*> living() const;

private:
    friend class FiberScheduler;
    friend class Process;
    friend class Worker;

    void add(Process&);
    void remove(Process&);
    Process* choose_next();
    void switch_to(Process*);
    void employ(Process&);
    void finish(Process&) noexcept;
    void unwind_all();

    static thread_local Kernel* current_;

    Time now_{}, limit_{Time::max()};
    ProcessQueue ready_;
    EventQueue future_;
    Fingerprint fingerprint_;
    Process* running_ = nullptr;
    std::vector<Process*> processes_;
    std::uint32_t next_ordinal_ = 0;
    std::uint64_t wires_ = 0;

    std::vector<std::unique_ptr<Worker>> workers_;
    std::vector<Worker*> idle_;
    FiberScheduler* scheduler_ = nullptr;
    bool unwinding_ = false;
    bool limit_reached_ = false;
    std::atomic<bool> interrupted_{false};
    std::exception_ptr failure_;
};

/// Thrown through a process that still waits when its simulation is over, so that its stack is unwound.
/// A process that catches everything must let this one pass.
class Unwinding {};

} // namespace placedpar
