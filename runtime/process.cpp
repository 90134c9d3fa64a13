#include "runtime/process.hpp"

#include "runtime/executive.hpp"
#include "runtime/kernel.hpp"
#include "runtime/trace.hpp"

#include <fmt/format.h>

#include <utility>

namespace placedpar {

Process::Process(Kernel& kernel, std::string name, Body body, Executive* executive, Priority priority)
    : kernel_(kernel), name_(std::move(name)), body_(std::move(body)), executive_(executive), priority_(priority) {
    kernel_.add(*this);
}

Process::Process(Process& parent, std::size_t index, Body body, Priority priority, Join& join)
    : kernel_(parent.kernel_), index_(index), body_(std::move(body)), executive_(parent.executive_),
      priority_(priority), join_(&join), outermost_(parent.outermost_) {
    kernel_.add(*this);
    goes_on();
    if (TraceSink* trace = kernel_.trace())
        trace->began(*this, kernel_.now());
}

Process::~Process() { kernel_.remove(*this); }

void Process::serve_machine() { kernel_.program_processes_ -= !std::exchange(machine_, true); }

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

/// Ends with the wait, also when that ends because the run does.
struct Process::Standstill {
    explicit Standstill(Process& p) : process(p) {}
    ~Standstill() { process.goes_on(); }
    Process& process;
};

/// Null: for no channel.
inline void Process::awaits(const AnyChannel* channel) {
    awaited_channel_ = channel;
    awaited_ = {&awaited_channel_, channel ? std::size_t{1} : 0};
}

inline void Process::note_wait(Activity activity) {
    activity_ = activity;
    if (TraceSink* trace = kernel_.trace())
        trace->waits(*this, kernel_.now());
    stands_still();
}

inline void Process::note_end_of_wait() {
    if (TraceSink* trace = kernel_.trace())
        trace->goes_on(*this, kernel_.now());
    activity_ = Activity::ready;
}

inline void Process::finish_wait(Process* successor) {
    {
        Standstill standstill(*this);
        kernel_.wait(successor);
    }
    note_end_of_wait();
}

void Process::begin_wait(Activity activity, const AnyChannel* channel, const SourceLocation& where) {
    awaits(channel);
    awaits_timer_ = activity == Activity::delayed || may_give_up_;
    where_ = where;
    note_wait(activity);
}

/// All that a wait passes through is to be one function: where another fiber was on the processor meanwhile, it does
/// not foresee where a call returns to.
[[gnu::flatten]] void Process::wait_for(Activity activity, const AnyChannel* channel, const SourceLocation& where) {
    begin_wait(activity, channel, where);
    finish_wait();
}

void Process::wait_for(Activity activity, std::span<const AnyChannel* const> channels, const SourceLocation& where,
                       bool awaits_timer) {
    awaited_ = channels;
    awaits_timer_ = awaits_timer;
    where_ = where;
    note_wait(activity);
    finish_wait();
    awaits(nullptr);
}

/// Off the executive, if the process waits.
bool Process::execute_instruction() {
    Instruction& instruction = *std::exchange(instruction_, nullptr);
    instruction.waits_ = !instruction.execute(*this);
    if (instruction.waits_ && executive_)
        executive_->leave(*this, nullptr);
    return !instruction.waits_;
}

void Process::compute_and_execute(Instruction& instruction, Cycles cycles) {
    // The run may end during the computation, and during the wait.
    struct End {
        ~End() {
            process.instruction_ = nullptr;
            if (instruction.waits_)
                process.goes_on();
        }
        Process& process;
        Instruction& instruction;
    };
    {
        End end{*this, instruction};
        instruction_ = &instruction;
        instruction.waits_ = false;
        if (executive_)
            executive_->compute(cycles, {});
        if (instruction_ && !execute_instruction())
            kernel_.give_way();
    }
    if (instruction.waits_)
        note_end_of_wait();
}

void Process::wait_for_components(Process& last, const SourceLocation& where) {
    awaits(nullptr);
    awaits_timer_ = false;
    where_ = where;
    note_wait(Activity::joining);
    finish_wait(executive_ ? &last : nullptr);
}

std::optional<Time> Process::waits_since() const {
    return ended() || going_on_ > 0 ? std::nullopt : std::optional(still_since_);
}

Time Process::time_waited() const {
    Time now = kernel_.now();
    return waited_ + (now - waits_since().value_or(now));
}

void Process::was_delayed(Time since, const SourceLocation& where) {
    awaits(nullptr);
    awaits_timer_ = true;
    where_ = where;
    if (outermost_->going_on_ == 1)
        outermost_->waited_ += kernel_.now() - since;
    activity_ = Activity::delayed;
    if (TraceSink* trace = kernel_.trace()) {
        trace->waits(*this, since);
        trace->goes_on(*this, kernel_.now());
    }
    activity_ = Activity::ready;
}

} // namespace placedpar
