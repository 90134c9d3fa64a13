#include "runtime/kernel.hpp"

#include "runtime/fiber_scheduler.hpp"
#include "runtime/processor.hpp"
#include "runtime/worker.hpp"

#include <boost/fiber/fiber.hpp>
#include <boost/fiber/fixedsize_stack.hpp>
#include <boost/fiber/operations.hpp>
#include <boost/fiber/algo/round_robin.hpp>

#include <algorithm>
#include <cassert>
#include <stdexcept>

namespace placedpar {

namespace {

#if defined(__SANITIZE_ADDRESS__)
constexpr std::size_t stack_bytes = 512 * 1024; // red zones make frames several times larger
#else
constexpr std::size_t stack_bytes = 64 * 1024;
#endif

} // namespace

thread_local Kernel* Kernel::current_ = nullptr;

Kernel::Kernel() = default;
Kernel::~Kernel() = default;

void Kernel::add(Process& p) {
    p.ordinal_ = next_ordinal_++;
    p.slot_ = processes_.size();
    processes_.push_back(&p);
}

void Kernel::remove(Process& p) {
    processes_[p.slot_] = processes_.back();
    processes_[p.slot_]->slot_ = p.slot_;
    processes_.pop_back();
}

void Kernel::make_ready(Process& p) {
    if (p.processor_)
        p.processor_->make_ready(p);
    else
        enqueue(p);
}

Process* Kernel::choose_next() {
    for (;;) {
        if (failure_ || limit_reached_ || interrupted_.load(std::memory_order_relaxed))
            return nullptr;
        if (Process* p = ready_.pop_front())
            return p;
        if (future_.empty())
            return nullptr;
        if (future_.next_time() > limit_) {
            limit_reached_ = true;
            return nullptr;
        }
        now_ = future_.next_time();
        future_.happen_next();
    }
}

bool Kernel::pass_time(Time until) {
    if (!ready_.empty() || until > limit_ || unwinding_ || (!future_.empty() && future_.next_time() <= until))
        return false;
    now_ = until;
    return true;
}

/// Null stands for the fiber that called run.
void Kernel::switch_to(Process* p) {
    running_ = p;
    if (p)
        p->worker_->resume();
    else
        scheduler_->host()->resume();
}

/// Gives a process that has its first turn a fiber.
void Kernel::employ(Process& p) {
    if (idle_.empty()) {
        workers_.push_back(std::make_unique<Worker>(*this));
        idle_.push_back(workers_.back().get());
    }
    p.worker_ = idle_.back();
    p.worker_->process = &p;
    idle_.pop_back();
}

void Kernel::wait() {
    Process& self = *running_;
    if (self.processor_ && !unwinding_)
        self.processor_->release(self);
    give_way();
}

void Kernel::give_way() {
    Process& self = *running_;
    if (!unwinding_) {
        Process* next = choose_next();
        if (next != &self) {
            if (next && !next->worker_)
                employ(*next);
            switch_to(next);
        }
    }
    if (unwinding_)
        throw Unwinding{};
}

/// The process that ran on the worker has ended: whoever waits in a PAR for it may go on.
void Kernel::finish(Process& p) noexcept {
    p.activity_ = Activity::ended;
    fingerprint_.mix(static_cast<std::uint64_t>(now_.count()));
    fingerprint_.mix(p.ordinal_);
    idle_.push_back(p.worker_);
    p.worker_ = nullptr;
    if (unwinding_)
        return;
    if (p.processor_)
        p.processor_->release(p);
    if (p.join_ && --p.join_->components_left == 0)
        make_ready(p.join_->parent);
}

Worker::Worker(Kernel& kernel) {
    kernel.scheduler_->expect_worker();
    boost::fibers::fiber(boost::fibers::launch::post, std::allocator_arg,
                         boost::fibers::fixedsize_stack(stack_bytes), [this, &kernel] { work(kernel); })
        .detach();
    context_ = kernel.scheduler_->newest_worker();
}

void Worker::work(Kernel& kernel) {
    while (!dismissed) {
        Process& self = *process;
        try {
            self.body_();
        } catch (const Unwinding&) {
        } catch (...) {
            if (!kernel.failure_ && !kernel.unwinding_)
                kernel.failure_ = std::current_exception();
        }
        process = nullptr;
        kernel.finish(self);
        Process* next = kernel.unwinding_ ? nullptr : kernel.choose_next();
        if (next && !next->worker_)
            kernel.employ(*next);
        kernel.running_ = next;
        if (next && next->worker_ == this)
            continue;
        kernel.switch_to(next);
    }
}

Ending Kernel::run(Time limit, const std::function<void(Ending)>& at_end) {
    if (current_)
        throw std::logic_error("a simulation is already running on this thread");
    current_ = this;
    limit_ = limit;
    auto* host = boost::fibers::context::active();
    boost::fibers::use_scheduling_algorithm<FiberScheduler>(host, scheduler_);
    if (Process* first = choose_next()) {
        employ(*first);
        switch_to(first);
    }
    bool all_ended = living().empty();
    Ending ending = all_ended        ? Ending::completed
                    : interrupted_   ? Ending::interrupted
                    : limit_reached_ ? Ending::time_limit
                                     : Ending::stuck;
    if (!failure_)
        at_end(ending);
    unwind_all();
    boost::fibers::use_scheduling_algorithm<boost::fibers::algo::round_robin>();
    boost::this_fiber::yield(); // Boost's dispatcher frees the stacks of the workers
    scheduler_ = nullptr;
    current_ = nullptr;
    if (failure_)
        std::rethrow_exception(failure_);
    return ending;
}

/// Components before the processes that wait for them: the youngest first.
void Kernel::unwind_all() {
    unwinding_ = true;
    std::vector<Process*> left = processes_;
    std::ranges::sort(left, std::ranges::greater{}, &Process::ordinal_);
    for (Process* p : left) {
        if (p->worker_)
            switch_to(p);
        p->activity_ = Activity::ended;
    }
    scheduler_->dismissing(true);
    for (auto& worker : workers_) {
        worker->dismissed = true;
        worker->resume();
    }
    scheduler_->dismissing(false);
    workers_.clear();
    idle_.clear();
}

std::vector<const Process*> Kernel::living() const {
    std::vector<const Process*> result;
    for (const Process* p : processes_)
        if (!p->ended() && !p->serves_machine())
            result.push_back(p);
    std::ranges::sort(result, {}, &Process::ordinal_);
    return result;
}

} // namespace placedpar
