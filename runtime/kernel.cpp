#include "runtime/kernel.hpp"

#include "runtime/executive.hpp"
#include "runtime/fiber_scheduler.hpp"
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

/// Names the first process that computes or waits for its timer, as a hint: what comes too late is its own
/// computation or delay, or follows from it.
[[gnu::cold, gnu::noinline]] std::exception_ptr beyond_the_end_of_time(const Kernel& kernel) {
    const std::vector<const Process*> living = kernel.living();
    auto late = std::ranges::find_if(living, [](const Process* p) {
        return p->activity() == Activity::ready || p->activity() == Activity::delayed;
    });
    return std::make_exception_ptr(std::overflow_error(fmt::format(
        "virtual time lasts for {} days, and {} would pass that end: {}",
        std::chrono::floor<std::chrono::days>(Time::max()).count(),
        late == living.end() ? "a message on a link" : "process " + (*late)->path(),
        late == living.end() ? "give the link more speed, or send less" : "shorten its computation or delay")));
}

/// Out of the way of those that are taken in order.
[[gnu::cold, gnu::noinline]] void put_off_some(ProcessQueue& ready, RandomStream& lots) {
    while (!ready.empty() && lots.chance(0.5))
        ready.push_back(*ready.pop_front());
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
    throw std::logic_error("only a process of a simulation that runs can communicate, compute or wait");
}

[[gnu::cold, gnu::noinline]] void Kernel::unwind_running() {
    constexpr unsigned enough = 1000;
    if (++running_->times_unwound_ > enough) {
        std::fprintf(stderr, "process %s catches every exception, also the one that ends it: let Unwinding pass\n",
                     running_->path().c_str());
        std::abort();
    }
    throw Unwinding{};
}

/// The running process may have been doing such things for ever.
void Kernel::heed_operations() {
    if (circumstances_.any_of(Circumstances::interrupted))
        return give_way();
    if (operations_at_once_ > most_operations_at_once)
        throw std::logic_error(fmt::format("process {} computes for ever without any time passing", running_->path()));
}

Kernel::Kernel() { circumstances_.set(Circumstances::nobody_left); }
Kernel::~Kernel() = default;

void Kernel::add(Process& p) {
    p.ordinal_ = next_ordinal_++;
    p.slot_ = processes_.size();
    processes_.push_back(&p);
    if (program_processes_++ == 0)
        circumstances_.clear(Circumstances::nobody_left);
}

/// A process of the program has ended, or is none.
void Kernel::count_out() {
    if (--program_processes_ == 0)
        circumstances_.set(Circumstances::nobody_left);
}

void Kernel::remove(Process& p) {
    if (!p.ended() && !p.serves_machine())
        count_out();
    processes_[p.slot_] = processes_.back();
    processes_[p.slot_]->slot_ = p.slot_;
    processes_.pop_back();
}

void Kernel::tell_and_make_ready(Process& p) {
    if (trace_)
        trace_->turns(p, Activity::ready, now_);
    if (p.executive_)
        p.executive_->make_ready(p);
    else
        enqueue(p);
}

inline bool Kernel::over() const {
    return circumstances_.any_of(Circumstances::nobody_left | Circumstances::failed | Circumstances::at_the_limit |
                                 Circumstances::interrupted);
}

/// Lets the next event happen, unless the run ends before it.
[[gnu::noinline]] void Kernel::pass_to(Time next) {
    if (next > limit_) {
        now_ = limit_;
        circumstances_.set(Circumstances::at_the_limit);
    } else if (next == Time::max()) {
        fail_with(beyond_the_end_of_time(*this));
    } else {
        now_ = next;
        between_programs_ = true;
        future_.happen_next();
        between_programs_ = false;
    }
}

/// A rough figure of ours: a process that goes on looks at some ten lines of its stack, and a second-level cache of
/// half a Mbyte has 8,000 for everything.
constexpr std::size_t stacks_in_a_cache = 500;

inline bool Kernel::begin_communication(Process& p) {
    between_programs_ = true;
    bool waits = p.begin_communication();
    between_programs_ = false;
    return waits;
}

Process* Kernel::choose_next() {
    for (;;) {
        if (circumstances_.any()) [[unlikely]] {
            if (over())
                return nullptr;
            if (shuffle_)
                put_off_some(ready_, *shuffle_);
        }
        if (Process* p = ready_.pop_front()) {
            if (p->communication_ && begin_communication(*p))
                continue;
            return p;
        }
        if (!future_.empty())
            pass_to(future_.next_time());
        else if (!go_on_after_work())
            return nullptr;
    }
}

/// Ends the work and wakes those that wait for this; returns whether there are any.
[[gnu::cold, gnu::noinline]] bool Kernel::go_on_after_work() {
    if (after_work_.empty())
        return false;
    end_work();
    limit_ = Time::max();
    while (Process* p = after_work_.pop_front())
        make_ready(*p);
    return true;
}

void Kernel::end_work() {
    if (std::exchange(work_over_, true))
        return;
    tell(observer_.work_over);
    if (TraceSink* trace = std::exchange(trace_, nullptr))
        tell([&] { trace->over(now_); });
}

/// After a failure nothing is told.
void Kernel::tell(const std::function<void()>& observer) {
    try {
        if (!failure_)
            observer();
    } catch (...) {
        fail_with(std::current_exception());
    }
}

[[gnu::cold, gnu::noinline]] void Kernel::fail_with(std::exception_ptr what) {
    failure_ = std::move(what);
    circumstances_.set(Circumstances::failed);
}

/// The process to run next, with a fiber to run on; null when the run is over.
Process* Kernel::next_with_worker() {
    Process* next = choose_next();
    if (!next || (!next->worker_ && !employ(*next)))
        return nullptr;
    if (stacks_exceed_cache_) [[unlikely]]
        Worker::fetch_stack(running_, *next);
    return next;
}

bool Kernel::pass_time(Time until) {
    if (!ready_.empty() || until > limit_ || until == Time::max())
        return false;
    if (circumstances_.any() && (circumstances_.any_of(Circumstances::unwinding) || over())) [[unlikely]]
        return false;
    if (!future_.empty() && future_.next_time() <= until)
        return false;
    now_ = until;
    return true;
}

/// Null means the fiber that called run.
void Kernel::switch_to(Process* p) {
    running_ = p;
    SwitchedStack& from = *stack_in_use_;
    if (SwitchedStack::is_watched()) [[unlikely]] {
        stack_left_ = &from;
        stack_in_use_ = p ? &p->worker_->stack : &host_stack_;
        from.leave_for(*stack_in_use_);
    }
    if (p)
        p->worker_->resume();
    else
        scheduler_->host()->resume();
    from.arrive();
}

/// Gives a process that runs for the first time a fiber; returns whether there was memory for it. If not, the run ends.
[[gnu::cold, gnu::noinline]] bool Kernel::employ(Process& p) {
    try {
        if (idle_.empty()) {
            workers_.push_back(Worker::make(*this, stacks_.allocate()));
            idle_.push_back(workers_.back().get());
            if (!stacks_.all_guarded())
                circumstances_.set(Circumstances::unguarded);
            stacks_exceed_cache_ = workers_.size() > stacks_in_a_cache;
        }
    } catch (...) {
        fail_with(std::current_exception());
        return false;
    }
    p.worker_ = idle_.back();
    p.worker_->process = &p;
    idle_.pop_back();
    return true;
}

void Kernel::wait(Process* successor) {
    Process& self = *running_;
    if (self.executive_ && !circumstances_.any_of(Circumstances::unwinding))
        self.executive_->leave(self, successor);
    give_way();
}

void Kernel::give_way() {
    Process& self = *running_;
    if (circumstances_.any()) [[unlikely]] {
        throw_if_unwinding();
        if (circumstances_.any_of(Circumstances::unguarded))
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
    const Process* running = current_ ? current_->running_ : nullptr;
    if (!running || !running->worker_ || !running->worker_->memory.was_left_for(address))
        return std::nullopt;
    return stack_user(*running);
}

/// Ends the program when the process has written beyond its stack, where nobody watches that at once.
[[gnu::cold, gnu::noinline]] void Kernel::require_own_stack(const Process& process) {
    const Stack& stack = process.worker_->memory;
    if (stack.guarded || !stack.has_overflowed())
        return;
    report_stack_overflow(stack_user(process));
    std::abort();
}

/// The process that ran on the worker throws. Only the first failure counts.
void Kernel::fail(const Process& p) noexcept {
    if (circumstances_.any_of(Circumstances::failed | Circumstances::unwinding))
        return;
    fail_with(std::current_exception());
    who_failed_ = {p.path(), now_, text_of(p.place_in_program())};
}

/// The process that ran on the worker has ended. If it was the last component of a PAR, its parent can go on.
void Kernel::finish(Process& p) noexcept {
    if (!stacks_.all_guarded())
        require_own_stack(p);
    p.activity_ = Activity::ended;
    p.stands_still();
    if (!p.serves_machine())
        count_out();
    fingerprint_.mix(static_cast<std::uint64_t>(now_.count()));
    fingerprint_.mix(p.ordinal_);
    idle_.push_back(p.worker_);
    p.worker_ = nullptr;
    if (circumstances_.any_of(Circumstances::unwinding))
        return;
    if (trace_)
        trace_->turns(p, Activity::ended, now_);
    Process* parent = p.join_ && --p.join_->components_left == 0 ? &p.join_->parent : nullptr;
    if (p.executive_)
        p.executive_->leave(p, parent);
    else if (parent)
        make_ready(*parent);
}

Ending Kernel::run(Time limit, Observer observer) {
    if (current_)
        throw std::logic_error("a simulation is already running on this thread");
    if (circumstances_.any_of(Circumstances::unwinding))
        throw std::logic_error("a simulation runs only once");
    limit_ = limit;
    observer_ = std::move(observer);
    boost::fibers::use_scheduling_algorithm<FiberScheduler>(boost::fibers::context::active(), scheduler_);
    current_ = this;
    StackOverflowWatch watch(who_overflowed);
    stack_in_use_ = &host_stack_;
    introduce_to_trace();
    if (Process* first = next_with_worker())
        switch_to(first);
    Ending how = ending();
    end_work();
    tell([&] { observer_.run_over(how); });
    unwind_all();
    current_ = nullptr;
    boost::fibers::use_scheduling_algorithm<boost::fibers::algo::round_robin>();
    scheduler_ = nullptr;
    if (failure_)
        std::rethrow_exception(failure_);
    return how;
}

Ending Kernel::ending() const {
    if (living().empty())
        return Ending::completed;
    if (circumstances_.any_of(Circumstances::interrupted))
        return Ending::interrupted;
    return circumstances_.any_of(Circumstances::at_the_limit) ? Ending::time_limit : Ending::stuck;
}

std::vector<Process*> Kernel::by_age() const {
    std::vector<Process*> result = processes_;
    std::ranges::sort(result, {}, &Process::ordinal_);
    return result;
}

/// The processes that were made before the run.
void Kernel::introduce_to_trace() {
    if (trace_)
        for (const Process* p : by_age())
            trace_->turns(*p, Activity::starting, now_);
}

/// The youngest process first, so that components go before the processes that wait for them.
void Kernel::unwind_all() {
    circumstances_.set(Circumstances::unwinding);
    std::vector<Process*> left = by_age();
    std::ranges::reverse(left);
    for (Process* p : left) {
        p->history_ = nullptr;
        if (p->worker_)
            switch_to(p);
        p->activity_ = Activity::ended;
    }
    workers_.clear();
    idle_.clear();
}

std::vector<const Process*> Kernel::living() const {
    std::vector<const Process*> result;
    for (const Process* p : by_age())
        if (!p->ended() && !p->serves_machine())
            result.push_back(p);
    return result;
}

} // namespace placedpar
