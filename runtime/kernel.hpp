#pragma once

#include "runtime/event.hpp"
#include "runtime/fingerprint.hpp"
#include "runtime/process.hpp"
#include "runtime/random.hpp"
#include "runtime/rare_conditions.hpp"
#include "runtime/stack_arena.hpp"
#include "runtime/stack_overflow.hpp"
#include "runtime/switched_stack.hpp"
#include "runtime/time.hpp"

#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace placedpar {

class FiberScheduler;
class ReplayLog;
class Surroundings;
class TraceSink;

/// The reason why a run ended. `stuck`: nothing more can happen, but some processes still wait.
enum class Ending { completed, stuck, time_limit, interrupted };

/// Returns a word such as "completed" or "deadlock".
const char* name_of(Ending);

/// Destroys a worker, that is, a fiber that runs processes. The worker is not on the heap: its memory is part of the
/// fiber's stack.
struct EndWorker {
    void operator()(Worker*) const;
};

/// Thrown through each process that still waits when its simulation is over, so that destructors clean up the process's
/// stack. A process that catches all exceptions must rethrow this one. During unwinding, destructors may not
/// communicate, compute or wait.
class Unwinding {};

/// The process that threw an exception, the time, and the place of the process's last wait, such as "slave.cpp:57". The
/// place is empty if the process never waited.
struct Failure {
    std::string process;
    Time time{};
    std::string where;
};

/// Decides which process runs next, and keeps the virtual time. A program uses the kernel through Simulation; devices
/// and occam's constructs use it directly. An executive is the device that executes a process: a processor, a bus
/// master or a workstation.
///
/// The rule of ordering: ready processes run in the order in which they became ready, each until it waits. When no
/// process is ready, the earliest event happens, and virtual time becomes its time. Events of the same time happen by
/// priority (EventQueue::Priority). Within a priority they happen by rank (new_ranks) or, without ranks, in the order
/// in which they were scheduled. Nothing else influences the order, so a simulation is deterministic.
///
/// In a native run, where processes run in real time on several threads, this rule does not hold: see run_among().
///
/// The work of a run is over when no process is ready and no event is scheduled. The work is also over when every
/// process of the program has ended, even if the machine could continue. At the end of the work the run ends. However,
/// processes that called after_work() continue first.
///
/// 1. A kernel is used by one thread; only interrupt() may be called from another thread.
/// 2. A kernel runs once, and no other kernel runs on its thread during the run.
/// 3. wait(), give_way() and running() may be called only by the process that is being executed.
/// 4. A process is destroyed before its kernel, and only when it has ended or the run is over.
///
/// Processes run on Boost fibers. When a process ends, its fiber is used for another process, so a PAR in a loop needs
/// no new stacks.
class Kernel {
public:
    Kernel();
    ~Kernel();
    Kernel(const Kernel&) = delete;
    Kernel& operator=(const Kernel&) = delete;

    /// Returns the kernel that this thread is running; null outside of a run.
    static Kernel* current() { return current_; }
    /// Returns the kernel that runs the caller. Throws std::logic_error if the caller is not a process, because only
    /// processes can communicate, compute or wait.
    static Kernel& here() {
        if (!current_ || !current_->hot_.running)
            refuse_outside_a_run();
        return *current_;
    }

    Time now() const { return hot_.now; }
    /// Returns the time limit of the work. Nothing happens after it.
    Time limit() const { return hot_.limit; }
    /// Returns the process whose program is being executed.
    Process& running() const { return *hot_.running; }
    /// Returns the running process, like running(). Returns null while an event happens, and while the kernel begins a
    /// communication for a process.
    const Process* who_runs() const { return hot_.between_programs ? nullptr : hot_.running; }
    EventQueue& future() { return hot_.future; }
    Fingerprint& fingerprint() { return hot_.fingerprint; }
    /// Returns the sink of the trace; null if the run is not traced.
    TraceSink* trace() const { return hot_.trace; }
    void trace_to(TraceSink& sink) { hot_.trace = &sink; }
    /// Reserves `count` successive ranks for a device's events, and returns the first rank. Simultaneous events of one
    /// priority happen in the order of their ranks, whenever they were scheduled.
    std::uint64_t new_ranks(std::uint64_t count) { return std::exchange(ranks_, ranks_ + count); }

    /// Lets a process continue: at once if it has no executive, otherwise when its turn on the executive comes.
    void make_ready(Process& p) {
        if (hot_.trace || p.executive())
            tell_and_make_ready(p);
        else
            enqueue(p);
    }
    /// Makes a process ready at the beginning of the run. The processes begin in the order of these calls, unless the
    /// run is shuffled. During the run, the function makes the process ready at once.
    void start(Process& p);
    /// Removes the next process from an executive's queue and returns it: the first one, or, in a shuffled run, a
    /// random one. Returns null if the queue is empty. Executives call this.
    Process* take_next(ProcessQueue& queue) {
        if (hot_.rare_conditions.any_of(RareConditions::shuffled)) [[unlikely]]
            put_off_some(queue);
        return queue.pop_front();
    }
    /// Returns the random numbers of a shuffled run; null if the run is not shuffled.
    RandomStream* lots() { return shuffle_ ? &*shuffle_ : nullptr; }
    /// Puts the process at the back of the ready queue. Only executives call this; all others call make_ready().
    void enqueue(Process& p) { hot_.ready.push_back(p); }
    /// Takes the running process off its executive, and runs other processes until this process is made ready again.
    /// Also makes `successor` ready, unless it is null. Throws Unwinding when the simulation is over. REQUIRES: the
    /// successor has an executive.
    void wait(Process* successor = nullptr);
    /// Runs other processes until the running process is made ready, but does not take it off its executive. For a
    /// process that keeps its executive while it computes, and for a process that has already left its executive.
    void give_way();
    /// Begins an operation of the running process: output, input, ALT, computation, delay or PAR. Returns the process's
    /// history, that is, the log in which it must record the operation (Process::keep), or null if it keeps none.
    /// Throws Unwinding when the simulation is over. In a run with histories, throws Unwinding also after an
    /// interruption, because a process that repeats its history never waits. Ends the program with a message if the
    /// process has caught Unwinding many times.
    ReplayLog* begin_operation(const Process& running) {
        if (hot_.rare_conditions.any_of(RareConditions::unwinding | RareConditions::histories)) [[unlikely]]
            return attend(running);
        return nullptr;
    }
    /// Returns whether processes record their operations in histories.
    bool keeps_histories() const { return hot_.rare_conditions.any_of(RareConditions::histories); }
    /// Counts an operation that took no virtual time, to detect a process that polls for ever without letting time
    /// pass. From the operation after the first `unchecked` ones on, throws Unwinding if the run was interrupted. After
    /// `most_operations_at_once` operations at one time, throws std::logic_error. Throws nothing while processes are
    /// unwound.
    void count_timeless_operation(std::uint64_t unchecked = 0) {
        if (std::exchange(hot_.operations_at, hot_.now) != hot_.now)
            hot_.operations_at_once = 0;
        if (++hot_.operations_at_once > unchecked)
            check_timeless_operations();
    }
    static constexpr std::uint64_t most_operations_at_once = 100'000'000;
    /// The number of clock readings at one virtual time that are not checked. These readings never throw, so a
    /// destructor may read the clock.
    static constexpr std::uint64_t unchecked_readings = most_operations_at_once / 1000;
    /// Makes the process ready when the work is over. REQUIRES: the process then waits.
    void after_work(Process& p) { end_.after_work.push_back(p); }
    /// Advances virtual time to `until` if nothing else can happen before or at that time. Returns whether time was
    /// advanced. The effect is that of a wait, without two context switches.
    bool pass_time(Time until);

    /// The functions that the kernel calls at the end of the work, and at the end of the run.
    struct Observer {
        std::function<void()> work_over = [] {};
        std::function<void(Ending)> run_over = [](Ending) {};
    };
    /// Runs until the end. `limit`: the time limit of the work. Only the work is traced. The observer is called while
    /// the remaining processes are still in their waits. Then these processes are unwound by Unwinding. Rethrows what a
    /// process or the observer threw. If a process threw, the observer is not called. Throws std::logic_error if a
    /// simulation is already running on this thread, or if the kernel has run before. Throws std::overflow_error if the
    /// next event is beyond the end of virtual time.
    ///
    /// May be called from a Boost fiber. The thread's other fibers are not resumed during the run. Afterwards they are
    /// scheduled round robin, even if another algorithm was in use before.
    Ending run(Time limit, Observer);
    /// Makes the run take ready processes in a random order, drawn from the seed: processes at the beginning of the
    /// run, those that wait for an executive, and the components of a PAR. A correct program must work in every order,
    /// so a shuffled run can reveal a fault. Priorities still hold.
    void shuffle(std::uint64_t seed) {
        shuffle_.emplace(seed, "ready queue");
        hot_.rare_conditions.set(RareConditions::shuffled);
    }
    /// Makes this kernel one of the kernels of a native run, which runs processes in real time on several threads or
    /// programs. The kernel's time is the wall clock, and messages come from the other kernels. An event that is due
    /// happens between two turns of processes. Processes that a message or an event has woken run first (TurnsOfWoken).
    /// The run is over when no kernel has anything to do. `number` is the number of this kernel in the run. REQUIRES:
    /// called before the run; the surroundings outlive the run.
    void run_among(Surroundings& surroundings, std::uint32_t number);
    /// Returns the surroundings, that is, the clock and the other kernels of a native run; null in virtual time.
    Surroundings* surroundings() const { return surroundings_; }
    std::uint32_t number() const { return number_; }
    /// Sets now() to the time of the wall clock. Does nothing in virtual time.
    void look_at_clock() {
        if (surroundings_) [[unlikely]]
            read_wall_clock();
    }
    /// Ends the run before the next process or event. May be called from a signal handler or another thread.
    void interrupt() { hot_.rare_conditions.set(RareConditions::interrupted); }

    /// Returns the failure that ended the run, if a process threw an exception.
    const std::optional<Failure>& who_failed() const { return end_.who_failed; }
    /// Returns every process of the program that has not ended, in the order of creation. Processes that serve the
    /// machine (Process::serve_machine) are left out.
    std::vector<const Process*> living() const;

private:
    friend class FiberScheduler;
    friend class Process;
    friend class Worker;

    [[noreturn]] static void refuse_outside_a_run();
    [[noreturn]] void unwind_running();
    void throw_if_unwinding() {
        if (hot_.rare_conditions.any_of(RareConditions::unwinding)) [[unlikely]]
            unwind_running();
    }
    ReplayLog* attend(const Process& running);
    void check_timeless_operations();
    void tell_and_make_ready(Process&);
    void put_off_some(ProcessQueue&);
    void start_all();

    void add(Process&);
    void remove(Process&);
    void count_out();
    bool over() const;
    std::vector<Process*> by_age() const;
    void introduce_to_trace();
    Process* choose_next();
    bool begin_communication(Process&);
    void pass_to(Time next);
    void read_wall_clock();
    void look_around();
    bool rest();
    void fail_with(std::exception_ptr);
    bool go_on_after_work();
    void end_work();
    void tell(const std::function<void()>&);
    Process* next_with_worker();
    void switch_to(Process*);
    static std::optional<StackUser> who_overflowed(const void* address);
    static void require_own_stack(const Process&);
    bool employ(Process&);
    void fail(const Process&) noexcept;
    void finish(Process&) noexcept;
    Ending ending() const;
    void unwind_all();

    static constinit thread_local Kernel* current_; // constinit: read without a test for initialisation

    /// The data that each step of a run needs, together in few cache lines.
    struct Hot {
        Time now{}, limit{Time::max()};
        RareConditions rare_conditions;
        ProcessQueue ready;
        EventQueue future;
        Fingerprint fingerprint;
        TraceSink* trace = nullptr;
        Process* running = nullptr;
        SwitchedStack* stack_in_use = nullptr;
        Time operations_at{};                 ///< time at which an operation last took no time
        std::uint64_t operations_at_once = 0; ///< number of such operations at this time
        bool between_programs = false;
        bool stacks_exceed_cache = false;
    };
    /// The existing processes.
    struct Population {
        std::vector<Process*> all;      ///< in any order
        std::size_t of_the_program = 0; ///< number of processes of the program that have not ended
        std::uint32_t next_ordinal = 0;
        ProcessQueue starting; ///< processes that become ready at the beginning of the run
    };
    /// The fibers on which processes run.
    struct Fibers {
        StackArena stacks;
        std::vector<std::unique_ptr<Worker, EndWorker>> workers;
        std::vector<Worker*> idle; ///< workers without a process
        FiberScheduler* scheduler = nullptr;
        SwitchedStack host_stack; ///< the stack of the fiber that called run()
        SwitchedStack* stack_left = nullptr;
    };
    /// The state of a native run.
    struct Native {
        ProcessQueue woken; ///< ready processes that an arrival or an event has woken
        TurnsOfWoken turns;
    };
    /// The state of the end of the work and of the run.
    struct End {
        ProcessQueue after_work; ///< processes that wait for the end of the work
        Observer observer;
        bool work_over = false;
        std::exception_ptr failure; ///< exception that ended the run: RareConditions::failed
        std::optional<Failure> who_failed;
    };

    Hot hot_;
    Population population_;
    Fibers fibers_;
    End end_;
    Native native_;
    std::uint64_t ranks_ = 0;              ///< number of ranks that were given out
    std::optional<RandomStream> shuffle_;  ///< set if RareConditions::shuffled is set
    Surroundings* surroundings_ = nullptr; ///< not null if RareConditions::native is set
    std::uint32_t number_ = 0;
};

} // namespace placedpar
