#include "runtime/kernel.hpp"

#include "runtime/executive.hpp"
#include "runtime/fiber_scheduler.hpp"
#include "runtime/surroundings.hpp"
#include "runtime/trace.hpp"
#include "runtime/worker.hpp"

#include <boost/fiber/algo/round_robin.hpp>
#include <boost/fiber/operations.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace placedpar {

namespace {

/// Returns the error for a run whose next event is beyond the end of virtual time. The error names the first process
/// that computes or waits for its timer, because this computation or delay may be too long.
[[gnu::cold, gnu::noinline]] std::exception_ptr beyond_the_end_of_time(const Kernel& kernel) {
    const std::vector<const Process*> living = kernel.living();
    auto late = std::ranges::find_if(living, [](const Process* p) {
        return p->activity() == Activity::ready || p->activity() == Activity::delayed;
    });
    return std::make_exception_ptr(std::overflow_error(fmt::format(
        "virtual time ends after {} days, but {} would take longer: {}",
        std::chrono::floor<std::chrono::days>(Time::max()).count(),
        late == living.end() ? "a message on a link" : "process " + (*late)->path(),
        late == living.end() ? "give the link more speed, or send less" : "shorten its computation or delay")));
}

} // namespace

const char* name_of(Ending ending) {
    switch (ending) {
    case Ending::completed: return "completed";
    case Ending::stuck: return "deadlock";
    case Ending::time_limit: return "stopped at the time limit";
    case Ending::interrupted: return "interrupted";
    }
    return "";
}

constinit thread_local Kernel* Kernel::current_ = nullptr;

void Kernel::refuse_outside_a_run() {
    throw std::logic_error("only a process of a running simulation can communicate, compute or wait");
}

[[gnu::cold, gnu::noinline]] void Kernel::unwind_running() {
    constexpr unsigned enough = 1000;
    if (++hot_.running->times_unwound_ > enough) {
        std::fprintf(stderr, "process %s catches every exception, including the one that ends it: rethrow Unwinding\n",
                     hot_.running->path().c_str());
        std::abort();
    }
    throw Unwinding{};
}

/// Handles the rare cases of begin_operation(), which is inlined and must stay short.
[[gnu::cold, gnu::noinline]] ReplayLog* Kernel::attend(const Process& running) {
    if (hot_.rare_conditions.any_of(RareConditions::unwinding | RareConditions::interrupted))
        give_way();
    return running.history();
}

/// Checks a process that has done many operations while virtual time stood still, because it may poll for ever. Throws
/// std::logic_error after too many operations. If the run is interrupted, gives way, and the kernel then unwinds the
/// process.
void Kernel::check_timeless_operations() {
    if (hot_.rare_conditions.any_of(RareConditions::unwinding))
        return;
    if (hot_.rare_conditions.any_of(RareConditions::interrupted))
        return give_way();
    if (surroundings_)
        return read_wall_clock();
    if (hot_.operations_at_once > most_operations_at_once)
        throw std::logic_error(
            fmt::format("process {} computes for ever without any time passing", hot_.running->path()));
}

Kernel::Kernel() { hot_.rare_conditions.set(RareConditions::no_process_left); }
Kernel::~Kernel() = default;

void Kernel::add(Process& p) {
    p.ordinal_ = population_.next_ordinal++;
    p.slot_ = population_.all.size();
    population_.all.push_back(&p);
    if (population_.of_the_program++ == 0)
        hot_.rare_conditions.clear(RareConditions::no_process_left);
}

/// Subtracts one from the number of the program's processes, because a process has ended, or turns out to serve the
/// machine, as a router does.
void Kernel::count_out() {
    if (--population_.of_the_program == 0)
        hot_.rare_conditions.set(RareConditions::no_process_left);
}

void Kernel::remove(Process& p) {
    if (!p.ended() && !p.serves_machine())
        count_out();
    population_.all[p.slot_] = population_.all.back();
    population_.all[p.slot_]->slot_ = p.slot_;
    population_.all.pop_back();
}

void Kernel::tell_and_make_ready(Process& p) {
    if (hot_.trace)
        hot_.trace->turns(p, Activity::ready, hot_.now);
    if (p.executive_)
        p.executive_->make_ready(p);
    else
        enqueue(p);
}

/// Moves a random number of processes from the front of a queue to its end. REQUIRES: the run is shuffled.
[[gnu::cold, gnu::noinline]] void Kernel::put_off_some(ProcessQueue& queue) {
    while (!queue.empty() && shuffle_->chance(0.5))
        queue.push_back(*queue.pop_front());
}

void Kernel::start(Process& p) {
    if (current_ == this)
        make_ready(p);
    else
        population_.starting.push_back(p);
}

/// Makes the processes ready that begin with the run.
void Kernel::start_all() {
    std::vector<Process*> starting;
    while (Process* p = population_.starting.pop_front())
        starting.push_back(p);
    for (std::size_t left = starting.size(); shuffle_ && left > 1; --left)
        std::swap(starting[left - 1], starting[shuffle_->below(static_cast<std::uint32_t>(left))]);
    for (Process* p : starting)
        make_ready(*p);
}

inline bool Kernel::over() const {
    return hot_.rare_conditions.any_of(RareConditions::no_process_left | RareConditions::failed |
                                       RareConditions::at_the_limit | RareConditions::interrupted);
}

/// Performs the next event, unless the run ends before it.
[[gnu::noinline]] void Kernel::pass_to(Time next) {
    if (next > hot_.limit) {
        hot_.now = hot_.limit;
        hot_.rare_conditions.set(RareConditions::at_the_limit);
    } else if (next == Time::max()) {
        fail_with(beyond_the_end_of_time(*this));
    } else {
        hot_.now = next;
        hot_.between_programs = true;
        hot_.future.happen_next();
        hot_.between_programs = false;
    }
}

/// The number of stacks that fit into a second-level cache (our estimate); with more, prefetching is worth its time. A
/// process that continues reads about ten cache lines of its stack, and a cache of half a Mbyte has 8,000 lines.
constexpr std::size_t stacks_in_a_cache = 500;

inline bool Kernel::begin_communication(Process& p) {
    hot_.between_programs = true;
    bool waits = p.begin_communication();
    hot_.between_programs = false;
    return waits;
}

Process* Kernel::choose_next() {
    for (;;) {
        if (hot_.rare_conditions.any()) [[unlikely]] {
            if (over())
                return nullptr;
            if (surroundings_)
                look_around();
            if (shuffle_)
                put_off_some(hot_.ready);
        }
        if (Process* p = hot_.ready.pop_front()) {
            if (p->communication_ && begin_communication(*p))
                continue;
            return p;
        }
        if (surroundings_) [[unlikely]] {
            if (!rest())
                return nullptr;
        } else if (!hot_.future.empty())
            pass_to(hot_.future.next_time());
        else if (!go_on_after_work())
            return nullptr;
    }
}

void Kernel::run_among(Surroundings& surroundings, std::uint32_t number) {
    surroundings_ = &surroundings;
    number_ = number;
    hot_.rare_conditions.set(RareConditions::native);
}

[[gnu::cold, gnu::noinline]] void Kernel::read_wall_clock() { hot_.now = std::max(hot_.now, surroundings_->now()); }

/// In a native run, takes the messages of other kernels, and performs the events that are due.
[[gnu::noinline]] void Kernel::look_around() {
    read_wall_clock();
    hot_.between_programs = true;
    std::swap(hot_.ready, native_.woken);
    surroundings_->take_arrivals();
    while (!hot_.future.empty() && hot_.future.next_time() <= hot_.now)
        hot_.future.happen_next();
    std::swap(hot_.ready, native_.woken);
    hot_.between_programs = false;
    if (hot_.trace)
        read_wall_clock(); // so that the trace shows a woken process later than the message that woke it
    if (Process* const woken = native_.turns.next(native_.woken, !hot_.ready.empty()))
        hot_.ready.push_front(*woken);
}

/// In a native run, waits for messages of other kernels or for the next event. Returns false when the run is over.
[[gnu::noinline]] bool Kernel::rest() {
    const Time due = hot_.future.empty() ? Time::max() : hot_.future.next_time();
    const Surroundings::Rest rest = surroundings_->rest(due, !end_.after_work.empty());
    read_wall_clock();
    if (rest == Surroundings::Rest::quiet) {
        end_work();
        go_on_after_work();
    }
    return rest != Surroundings::Rest::forever;
}

/// Ends the work if processes wait for its end, and makes them ready. Returns whether there were such processes.
[[gnu::cold, gnu::noinline]] bool Kernel::go_on_after_work() {
    if (end_.after_work.empty())
        return false;
    end_work();
    hot_.limit = Time::max();
    while (Process* p = end_.after_work.pop_front())
        make_ready(*p);
    return true;
}

void Kernel::end_work() {
    if (std::exchange(end_.work_over, true))
        return;
    tell(end_.observer.work_over);
    if (TraceSink* trace = std::exchange(hot_.trace, nullptr))
        tell([&] { trace->over(hot_.now); });
}

/// Calls the observer, unless the run has failed.
void Kernel::tell(const std::function<void()>& observer) {
    try {
        if (!end_.failure)
            observer();
    } catch (...) {
        fail_with(std::current_exception());
    }
}

[[gnu::cold, gnu::noinline]] void Kernel::fail_with(std::exception_ptr what) {
    end_.failure = std::move(what);
    hot_.rare_conditions.set(RareConditions::failed);
}

/// Returns the process to run next, with a fiber for it. Returns null when the run is over.
Process* Kernel::next_with_worker() {
    Process* next = choose_next();
    if (!next || (!next->worker_ && !employ(*next)))
        return nullptr;
    if (hot_.stacks_exceed_cache) [[unlikely]]
        Worker::fetch_stack(hot_.running, *next);
    return next;
}

bool Kernel::pass_time(Time until) {
    if (surroundings_ || !hot_.ready.empty() || until > hot_.limit || until == Time::max())
        return false;
    if (hot_.rare_conditions.any() && (hot_.rare_conditions.any_of(RareConditions::unwinding) || over())) [[unlikely]]
        return false;
    if (!hot_.future.empty() && hot_.future.next_time() <= until)
        return false;
    hot_.now = until;
    return true;
}

/// Switches to the fiber of a process, or, if the process is null, to the fiber that called run().
void Kernel::switch_to(Process* p) {
    hot_.running = p;
    SwitchedStack& from = *hot_.stack_in_use;
    if (SwitchedStack::is_watched()) [[unlikely]] {
        fibers_.stack_left = &from;
        hot_.stack_in_use = p ? &p->worker_->stack : &fibers_.host_stack;
        from.leave_for(*hot_.stack_in_use);
    }
    if (p)
        p->worker_->resume();
    else
        fibers_.scheduler->host()->resume();
    from.arrive();
}

/// Gives a fiber to a process that runs for the first time. If there is not enough memory, makes the run fail, and
/// returns false.
[[gnu::cold, gnu::noinline]] bool Kernel::employ(Process& p) {
    try {
        if (fibers_.idle.empty()) {
            fibers_.workers.push_back(Worker::make(*this, fibers_.stacks.allocate()));
            fibers_.idle.push_back(fibers_.workers.back().get());
            if (!fibers_.stacks.all_guarded())
                hot_.rare_conditions.set(RareConditions::unguarded);
            hot_.stacks_exceed_cache = fibers_.workers.size() > stacks_in_a_cache;
        }
    } catch (...) {
        fail_with(std::current_exception());
        return false;
    }
    p.worker_ = fibers_.idle.back();
    p.worker_->process = &p;
    fibers_.idle.pop_back();
    if (hot_.trace && surroundings_)
        hot_.trace->turns(p, Activity::executing, hot_.now);
    return true;
}

void Kernel::wait(Process* successor) {
    Process& self = *hot_.running;
    if (self.executive_ && !hot_.rare_conditions.any_of(RareConditions::unwinding))
        self.executive_->leave(self, successor);
    give_way();
}

void Kernel::give_way() {
    Process& self = *hot_.running;
    if (hot_.rare_conditions.any()) [[unlikely]] {
        throw_if_unwinding();
        if (hot_.rare_conditions.any_of(RareConditions::unguarded))
            require_own_stack(self);
    }
    Process* next = next_with_worker();
    if (next != &self)
        switch_to(next);
    throw_if_unwinding();
}

namespace {

StackUser stack_user(const Process& process) { return {process.outermost().name(), process.parent() != nullptr}; }

} // namespace

std::optional<StackUser> Kernel::who_overflowed(const void* address) {
    const Process* running = current_ ? current_->hot_.running : nullptr;
    if (!running || !running->worker_ || !running->worker_->memory.was_left_for(address))
        return std::nullopt;
    return stack_user(*running);
}

/// Ends the program if the process has written beyond its stack. This check is for stacks without a guard zone, which
/// would detect an overflow at once.
[[gnu::cold, gnu::noinline]] void Kernel::require_own_stack(const Process& process) {
    const Stack& stack = process.worker_->memory;
    if (stack.guarded || !stack.has_overflowed())
        return;
    report_stack_overflow(stack_user(process));
    std::abort();
}

/// Records that the process has thrown an exception. Only the first failure counts.
void Kernel::fail(const Process& p) noexcept {
    if (hot_.rare_conditions.any_of(RareConditions::failed | RareConditions::unwinding))
        return;
    look_at_clock();
    fail_with(std::current_exception());
    end_.who_failed = {p.path(), hot_.now, text_of(p.place_in_program())};
}

/// Records that the process has ended. If it was the last component of a PAR, its parent can continue.
void Kernel::finish(Process& p) noexcept {
    if (!fibers_.stacks.all_guarded())
        require_own_stack(p);
    look_at_clock();
    p.activity_ = Activity::ended;
    p.stands_still();
    if (!p.serves_machine())
        count_out();
    hot_.fingerprint.mix(static_cast<std::uint64_t>(hot_.now.count()));
    hot_.fingerprint.mix(p.ordinal_);
    fibers_.idle.push_back(p.worker_);
    p.worker_ = nullptr;
    if (hot_.rare_conditions.any_of(RareConditions::unwinding))
        return;
    if (hot_.trace)
        hot_.trace->turns(p, Activity::ended, hot_.now);
    Process* parent = p.join_ && --p.join_->components_left == 0 ? &p.join_->parent : nullptr;
    if (p.executive_)
        p.executive_->leave(p, parent);
    else if (parent)
        make_ready(*parent);
}

Ending Kernel::run(Time limit, Observer observer) {
    if (current_)
        throw std::logic_error("a simulation is already running on this thread");
    if (hot_.rare_conditions.any_of(RareConditions::unwinding))
        throw std::logic_error("a simulation runs only once");
    hot_.limit = limit;
    end_.observer = std::move(observer);
    boost::fibers::use_scheduling_algorithm<FiberScheduler>(boost::fibers::context::active(), fibers_.scheduler);
    current_ = this;
    StackOverflowWatch watch(who_overflowed);
    hot_.stack_in_use = &fibers_.host_stack;
    start_all();
    introduce_to_trace();
    if (Process* first = next_with_worker())
        switch_to(first);
    Ending how = ending();
    if (surroundings_)
        surroundings_->wait_for_stop(end_.failure != nullptr);
    end_work();
    tell([&] { end_.observer.run_over(how); });
    if (surroundings_)
        surroundings_->wait_for_reports();
    unwind_all();
    current_ = nullptr;
    boost::fibers::use_scheduling_algorithm<boost::fibers::algo::round_robin>();
    fibers_.scheduler = nullptr;
    if (end_.failure)
        std::rethrow_exception(end_.failure);
    return how;
}

Ending Kernel::ending() const {
    if (living().empty())
        return Ending::completed;
    if (hot_.rare_conditions.any_of(RareConditions::interrupted))
        return Ending::interrupted;
    return hot_.rare_conditions.any_of(RareConditions::at_the_limit) ? Ending::time_limit : Ending::stuck;
}

std::vector<Process*> Kernel::by_age() const {
    std::vector<Process*> result = population_.all;
    std::ranges::sort(result, {}, &Process::ordinal_);
    return result;
}

/// Reports the processes that were made before the run to the trace.
void Kernel::introduce_to_trace() {
    if (hot_.trace)
        for (const Process* p : by_age())
            hot_.trace->turns(*p, Activity::starting, hot_.now);
}

/// Unwinds the youngest process first, so that components end before the processes that wait for them.
void Kernel::unwind_all() {
    hot_.rare_conditions.set(RareConditions::unwinding);
    std::vector<Process*> left = by_age();
    std::ranges::reverse(left);
    for (Process* p : left) {
        p->history_ = nullptr;
        if (p->worker_)
            switch_to(p);
        p->activity_ = Activity::ended;
    }
    fibers_.workers.clear();
    fibers_.idle.clear();
}

std::vector<const Process*> Kernel::living() const {
    std::vector<const Process*> result;
    for (const Process* p : by_age())
        if (!p->ended() && !p->serves_machine())
            result.push_back(p);
    return result;
}

} // namespace placedpar
