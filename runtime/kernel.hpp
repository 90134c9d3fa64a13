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
class TraceSink;

/// Why a run ended. `stuck`: processes are left that nothing will ever wake.
enum class Ending { completed, stuck, time_limit, interrupted };

/// "completed", "deadlock", ...
const char* name_of(Ending);

/// Destroys the worker; its memory is a part of its own stack.
struct EndWorker {
    void operator()(Worker*) const;
};

/// Thrown through a process that still waits when its simulation is over, so that its stack is unwound. A process
/// that catches everything must let this exception pass, and no destructor may communicate, compute or wait.
class Unwinding {};

/// Which process threw, when, and where it last waited ("slave.cpp:57"; empty if it never did).
struct Failure {
    std::string process;
    Time time{};
    std::string where;
};

/// Decides which process runs next, and what time it is.
///
/// The rule of ordering. Processes that are ready run in the order in which they became ready, each until it waits.
/// When none is ready, the earliest event happens and virtual time becomes its time; within an instant events happen
/// by priority (EventQueue::Priority), and within a priority by rank or, if they have none, by insertion. Nothing else
/// decides, and no wall clock is read, so a simulation is deterministic.
///
/// The work is over when no process is ready and no event is due, and also when every process of the program has ended,
/// even if the machine could continue. The run then ends too, unless processes have asked to continue after the work.
///
/// 1. A kernel is used by one thread; only interrupt() may be called from elsewhere.
/// 2. It runs once, and no other kernel runs on its thread meanwhile.
/// 3. wait, give_way and running are for a process that is being executed, and for what it calls.
/// 4. Processes are destroyed before their kernel, and when they have ended or the run is over.
///
/// Processes are Boost fibers. When a process ends, its fiber takes the next one, so that a PAR in a loop needs no new
/// stack.
class Kernel {
public:
    Kernel();
    ~Kernel();
    Kernel(const Kernel&) = delete;
    Kernel& operator=(const Kernel&) = delete;

    /// Returns the kernel that this thread is running; null outside a run.
    static Kernel* current() { return current_; }
    /// Returns the kernel that runs the caller. Throws std::logic_error if the caller is not a process: outside a run,
    /// a program cannot communicate, compute or wait.
    static Kernel& here() {
        if (!current_ || !current_->hot_.running)
            refuse_outside_a_run();
        return *current_;
    }

    Time now() const { return hot_.now; }
    /// Returns the process whose program is being executed.
    Process& running() const { return *hot_.running; }
    /// Returns the process whose program is being executed; null while an event happens, or the kernel begins a
    /// communication for a process.
    const Process* who_runs() const { return hot_.between_programs ? nullptr : hot_.running; }
    EventQueue& future() { return hot_.future; }
    Fingerprint& fingerprint() { return hot_.fingerprint; }
    /// Returns the sink of the trace; null if the run is not traced.
    TraceSink* trace() const { return hot_.trace; }
    void trace_to(TraceSink& sink) { hot_.trace = &sink; }
    /// Reserves `count` successive ranks for the events of a device, and returns the first of them. Devices rank in the
    /// order of their calls.
    std::uint64_t new_ranks(std::uint64_t count) { return std::exchange(ranks_, ranks_ + count); }

    /// Lets a process continue: at once if it is not placed, else when its executive gives it its turn.
    void make_ready(Process& p) {
        if (hot_.trace || p.executive())
            tell_and_make_ready(p);
        else
            enqueue(p);
    }
    /// Puts the process at the back of the ready queue. For executives; all others call make_ready.
    void enqueue(Process& p) { hot_.ready.push_back(p); }
    /// Takes the running process off its executive and runs others until it is made ready. A successor, which needs an
    /// executive, is made ready. Throws Unwinding when the simulation is over.
    void wait(Process* successor = nullptr);
    /// Runs other processes until the running process is made ready, but does not take it off its executive: it keeps
    /// the executive while it computes, or has left it already.
    void give_way();
    /// Every operation of the running process begins here: output, input, ALT, computation, delay, PAR. Returns the
    /// process's history, which records the operation; null if it keeps none. Throws Unwinding when the simulation is
    /// over, and in a run with histories also when that was interrupted: a process that repeats its history never
    /// waits, and would not notice otherwise. Ends the program with a message when the process has caught Unwinding
    /// many times.
    ReplayLog* begin_operation(const Process& running) {
        if (hot_.rare_conditions.any_of(RareConditions::unwinding | RareConditions::histories)) [[unlikely]]
            return attend(running);
        return nullptr;
    }
    /// Whether processes keep histories.
    bool keeps_histories() const { return hot_.rare_conditions.any_of(RareConditions::histories); }
    /// Counts an operation that took no time. When more than `unheeded` were counted since time last passed, an
    /// interruption ends the process here. Throws std::logic_error after `most_operations_at_once` of them, since
    /// nothing else would ever happen. Does neither while processes are unwound.
    void takes_no_time(std::uint64_t unheeded = 0) {
        if (std::exchange(hot_.operations_at, hot_.now) != hot_.now)
            hot_.operations_at_once = 0;
        if (++hot_.operations_at_once > unheeded)
            heed_operations();
    }
    static constexpr std::uint64_t most_operations_at_once = 100'000'000;
    /// Number of readings of the clock that are not checked for an interruption: a destructor may read the clock, and
    /// must not throw.
    static constexpr std::uint64_t unheeded_readings = most_operations_at_once / 1000;
    /// Makes the process ready when the work is over. It waits until then.
    void after_work(Process& p) { end_.after_work.push_back(p); }
    /// Moves virtual time on to `until` if nothing else could happen before or at that moment; returns whether it did.
    /// Same effect as waiting, without two context switches.
    bool pass_time(Time until);

    /// Functions that the kernel calls at the end of the work, and at the end of the run.
    struct Observer {
        std::function<void()> work_over = [] {};
        std::function<void(Ending)> run_over = [](Ending) {};
    };
    /// Runs until the end. The observer is called while the processes that are left still stand where they wait; then
    /// they are unwound. The limit is one for the work, and only the work is traced. Rethrows what a process or the
    /// observer threw; after a process threw, the observer is not called.
    /// Throws std::logic_error when a simulation is already running on this thread, and when called twice;
    /// std::overflow_error when nothing is left to happen before the end of virtual time, but something beyond it.
    ///
    /// It may be called from a Boost fiber. The thread's other fibers rest meanwhile; afterwards they are scheduled
    /// round robin, even if another algorithm was in use before.
    Ending run(Time limit, Observer);
    /// Runs ready processes in an order drawn from the seed, instead of the order in which they became ready. This is
    /// another possible execution of the program, which can show a dependence on the order. The scheduling of
    /// executives does not change.
    void shuffle(std::uint64_t seed) {
        shuffle_.emplace(seed, "ready queue");
        hot_.rare_conditions.set(RareConditions::shuffled);
    }
    /// Ends the run before the next process or event. May be called from a signal handler or another thread.
    void interrupt() { hot_.rare_conditions.set(RareConditions::interrupted); }

    /// Returns the process that ended the run by throwing, if there is one.
    const std::optional<Failure>& who_failed() const { return end_.who_failed; }
    /// Returns every process of the program that has not ended, in order of creation.
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
    void heed_operations();
    void tell_and_make_ready(Process&);

    void add(Process&);
    void remove(Process&);
    void count_out();
    bool over() const;
    std::vector<Process*> by_age() const;
    void introduce_to_trace();
    Process* choose_next();
    bool begin_communication(Process&);
    void pass_to(Time next);
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

    static constinit thread_local Kernel* current_; // constinit: it is read without asking whether it exists

    /// What each step of a run needs, side by side in few lines of the cache.
    struct Hot {
        Time now{}, limit{Time::max()};
        RareConditions rare_conditions;
        ProcessQueue ready;
        EventQueue future;
        Fingerprint fingerprint;
        TraceSink* trace = nullptr;
        Process* running = nullptr;
        SwitchedStack* stack_in_use = nullptr;
        Time operations_at{};                 ///< when the last operations that took no time were done
        std::uint64_t operations_at_once = 0; ///< how many operations took no time then
        bool between_programs = false;
        bool stacks_exceed_cache = false;
    };
    /// The processes that exist.
    struct Population {
        std::vector<Process*> all; ///< in no order
        std::size_t of_the_program =
            0; ///< processes of the program that have not ended; if 0: RareConditions::no_process_left
        std::uint32_t next_ordinal = 0;
    };
    /// What processes run on.
    struct Fibers {
        StackArena stacks;
        std::vector<std::unique_ptr<Worker, EndWorker>> workers;
        std::vector<Worker*> idle; ///< workers without a process
        FiberScheduler* scheduler = nullptr;
        SwitchedStack host_stack; ///< the stack of the fiber that called run()
        SwitchedStack* stack_left = nullptr;
    };
    /// How the work and the run end, and what is called then.
    struct End {
        ProcessQueue after_work; ///< processes that wait for the end of the work
        Observer observer;
        bool work_over = false;
        std::exception_ptr failure; ///< what a process threw: RareConditions::failed
        std::optional<Failure> who_failed;
    };

    Hot hot_;
    Population population_;
    Fibers fibers_;
    End end_;
    std::uint64_t ranks_ = 0;             ///< number of ranks that were given out
    std::optional<RandomStream> shuffle_; ///< RareConditions::shuffled
};

} // namespace placedpar
