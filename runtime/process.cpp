#include "runtime/process.hpp"

#include "runtime/executive.hpp"
#include "runtime/kernel.hpp"
#include "runtime/trace.hpp"

#include <fmt/format.h>

#include <utility>

namespace placedpar {

Process::Process(Kernel& kernel, std::string name, Body body, Executive* executive, Priority priority)
    : kernel_(kernel), executive_(executive), priority_(priority), name_(std::move(name)), body_(std::move(body)) {
    kernel_.add(*this);
}

Process::Process(Process& parent, std::size_t index, Body body, Priority priority, Join& join)
    : kernel_(parent.kernel_), executive_(parent.executive_), priority_(priority), outermost_(parent.outermost_),
      index_(index), body_(std::move(body)), join_(&join) {
    kernel_.add(*this);
    goes_on();
    if (TraceSink* trace = kernel_.trace())
        trace->turns(*this, Activity::starting, kernel_.now());
}

Process::~Process() { kernel_.remove(*this); }

void Process::keep(ReplayLog& history) {
    history_ = &history;
    kernel_.hot_.rare_conditions.set(RareConditions::histories);
}

void Process::serve_machine() {
    if (!std::exchange(machine_, true))
        kernel_.count_out();
}

std::string Process::path() const { return join_ ? fmt::format("{}/{}", join_->parent.path(), index_) : name_; }

bool Process::is_beside(std::uint32_t ordinal) const {
    for (const Process* p = this; p->join_; p = p->parent())
        if (ordinal != p->ordinal_ && ordinal - p->join_->first_ordinal < p->join_->components)
            return true;
    return false;
}

void Process::goes_on() {
    if (outermost_->going_on_++ == 0)
        outermost_->waited_ += kernel_.now() - outermost_->still_since_;
}

void Process::stands_still() {
    if (--outermost_->going_on_ == 0)
        outermost_->still_since_ = kernel_.now();
}

inline void Process::note_wait(Activity activity) {
    activity_ = activity;
    kernel_.look_at_clock();
    if (TraceSink* trace = kernel_.trace())
        trace->turns(*this, activity, kernel_.now());
    stands_still();
}

inline void Process::note_end_of_wait() {
    if (TraceSink* trace = kernel_.trace())
        trace->turns(*this, Activity::executing, kernel_.now());
    activity_ = Activity::ready;
}

inline void Process::finish_wait(Process* successor) {
    {
        // This destructor also runs if the run ends during the wait.
        struct End {
            ~End() { process.goes_on(); }
            Process& process;
        } end{*this};
        kernel_.wait(successor);
    }
    note_end_of_wait();
}

void Process::begin_wait(Activity activity, const AnyChannel* channel, const SourceLocation& where) {
    awaited_channel_ = channel;
    awaits_timer_ = activity == Activity::delayed || may_give_up_;
    where_ = where;
    note_wait(activity);
}

/// Waits for a channel. All functions of a wait are inlined here, because the host processor mispredicts the return
/// from a function in which it has switched to another fiber.
[[gnu::flatten]] void Process::wait_for(Activity activity, const AnyChannel* channel, const SourceLocation& where) {
    begin_wait(activity, channel, where);
    finish_wait();
}

void Process::wait_for(Activity activity, std::span<const AnyChannel* const> channels, const SourceLocation& where,
                       bool awaits_timer) {
    struct End {
        ~End() { process.alternatives_ = {}; }
        Process& process;
    } end{*this};
    awaited_channel_ = nullptr;
    alternatives_ = channels;
    awaits_timer_ = awaits_timer;
    where_ = where;
    note_wait(activity);
    finish_wait();
}

/// Begins a computation. Returns whether the computation is already done. A process without an executive computes in no
/// time.
inline bool Process::computes_at_once(Cycles cycles, const CodeShape& fineness) {
    kernel_.throw_if_unwinding();
    if (!executive_)
        return true;
    bool at_once = executive_->begin_computing(*this, cycles, fineness);
    if (at_once)
        kernel_.count_timeless_operation();
    return at_once;
}

[[gnu::flatten]] void Process::compute(Cycles cycles, const CodeShape& fineness) {
    if (!computes_at_once(cycles, fineness))
        kernel_.give_way();
}

/// Begins the communication. Returns whether the process must wait. In this case it leaves its executive, which takes
/// the next process.
bool Process::begin_communication() {
    communicates_ = std::exchange(communication_, nullptr)->begin(*this);
    if (communicates_ && executive_)
        executive_->leave(*this, nullptr);
    return communicates_;
}

[[gnu::flatten]] void Process::compute_and_communicate(Communication& communication, Cycles cycles) {
    bool has_waited = false;
    {
        // This destructor also runs if the run ends during the computation or the wait.
        struct End {
            ~End() {
                process.communication_ = nullptr;
                if (std::exchange(process.communicates_, false))
                    process.goes_on();
            }
            Process& process;
        } end{*this};
        communication_ = &communication;
        if (!computes_at_once(cycles, {}) || begin_communication())
            kernel_.give_way();
        has_waited = communicates_;
    }
    if (has_waited)
        note_end_of_wait();
}

void Process::wait_for_components(Process& successor, const SourceLocation& where) {
    awaited_channel_ = nullptr;
    awaits_timer_ = false;
    where_ = where;
    note_wait(Activity::joining);
    finish_wait(executive_ ? &successor : nullptr);
}

std::optional<Time> Process::waits_since() const {
    return ended() || going_on_ > 0 ? std::nullopt : std::optional(still_since_);
}

Time Process::time_waited() const {
    Time now = kernel_.now();
    return waited_ + (now - waits_since().value_or(now));
}

void Process::was_delayed(Time since, const SourceLocation& where) {
    awaited_channel_ = nullptr;
    awaits_timer_ = true;
    where_ = where;
    if (outermost_->going_on_ == 1)
        outermost_->waited_ += kernel_.now() - since;
    activity_ = Activity::delayed;
    if (TraceSink* trace = kernel_.trace()) {
        trace->turns(*this, Activity::delayed, since);
        trace->turns(*this, Activity::executing, kernel_.now());
    }
    activity_ = Activity::ready;
}

} // namespace placedpar
