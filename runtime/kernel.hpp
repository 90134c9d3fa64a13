#pragma once

#include "runtime/event.hpp"
#include "runtime/fingerprint.hpp"
#include "runtime/process.hpp"
#include "runtime/random.hpp"
#include "runtime/switched_stack.hpp"
#include "runtime/time.hpp"

#include <atomic>
#include <exception>
#include <memory>
#include <optional>
#include <vector>

namespace placedpar {

class FiberScheduler;
class TraceSink;

/// Why a run ended. `stuck`: processes are left that nothing will ever wake.
enum class Ending { completed, stuck, time_limit, interrupted };

/// Thrown through a process that still waits when its simulation is over, so that its stack is unwound.
/// A process that catches everything must let this one pass, and no
/// destructor may communicate, compute or wait.
class Unwinding {};

/// The heart of a simulation: who runs, and what time it is.
///
/// The rule: processes that are ready run in the order in which they became ready, each until it waits.
/// When nobody is ready, the earliest event of the future happens (time, then priority, then insertion) and
/// virtual time becomes that event's time. When nobody is ready and nothing is due, the run is over; it is
/// also over when every process of the program has ended, whatever the machine would still do.
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
    /// Null when nobody wants a trace.
    TraceSink* trace() const { return trace_; }
    void trace_to(TraceSink& sink) { trace_ = &sink; }
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
    /// Throws Unwinding when the simulation is over.
    void throw_if_unwinding() const {
        if (unwinding_)
            throw Unwinding{};
    }
    /// Moves virtual time on to `until` if nobody else could do anything up to then and at that moment;
    /// returns whether it did. It is what waiting would come to, without the switch to and fro.
    bool pass_time(Time until);

    /// Runs until the end. Rethrows what a process or `at_end` threw. On return every process has been unwound.
    /// `at_end` is called before that, while the processes that are stuck still stand where they are; not
    /// after a process threw. Throws std::logic_error when a simulation is already running on this thread,
    /// and when called twice; std::overflow_error when nothing is left to happen before the end of virtual time
    /// but something is beyond it.
    ///
    /// It may be called from a Boost fiber. The thread's other fibers rest meanwhile; afterwards they are
    /// scheduled round robin, whatever the algorithm was before.
    Ending run(Time limit, const std::function<void(Ending)>& at_end);
    /// Lets the processes that are ready run in an order drawn from the seed, not in the order in which they
    /// became ready: another of the program's possible courses, to shake out what depends on order.
    /// Processors share themselves out as before.
    void shuffle(std::uint64_t seed) { shuffle_.emplace(seed, "ready queue"); }
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
    bool over() const;
    Process* choose_ready();
    Process* choose_next();
    void pass_to(Time next);
    Process* next_with_worker();
    void switch_to(Process*);
    void employ(Process&);
    void finish(Process&) noexcept;
    Ending ending() const;
    void unwind_all();

    static thread_local Kernel* current_;

    Time now_{}, limit_{Time::max()};
    ProcessQueue ready_;
    EventQueue future_;
    Fingerprint fingerprint_;
    TraceSink* trace_ = nullptr;
    Process* running_ = nullptr;
    std::vector<Process*> processes_;
    std::size_t program_processes_ = 0; ///< those that have not ended
    std::uint32_t next_ordinal_ = 0;
    std::uint64_t wires_ = 0;

    std::vector<std::unique_ptr<Worker>> workers_;
    std::vector<Worker*> idle_;
    FiberScheduler* scheduler_ = nullptr;
    bool unwinding_ = false;
    bool limit_reached_ = false;
    std::atomic<bool> interrupted_{false};
    std::exception_ptr failure_;
    std::optional<RandomStream> shuffle_;
    SwitchedStack host_stack_; ///< of the fiber that called run
    SwitchedStack* stack_in_use_ = nullptr;
    SwitchedStack* stack_left_ = nullptr;
};

} // namespace placedpar
