#include "runtime/hardware/core.hpp"

#include "runtime/channel.hpp"
#include "runtime/kernel.hpp"
#include "runtime/surroundings.hpp"
#include "runtime/trace.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

namespace placedpar::hardware {

namespace {

/// Returns the costs of operations. An operation that was not measured takes one cycle if a program can repeat it while
/// polling, because time must then pass. Otherwise it takes no time.
OperationCosts costs_of(const CoreCosts& core) {
    return {.soft_communication = core.communication,
            .soft_word_output = core.communication,
            .hard_communication = core.crossing,
            .timer_read = Cycles{1},
            .timer_wait_past = Cycles{1},
            .enable_guard = Cycles{1}};
}

} // namespace

ComputerCore::ComputerCore(Kernel& kernel, std::string name, const CoreCosts& costs)
    : Executive(std::move(name), costs_of(costs)), kernel_(kernel), core_(costs) {
    const auto least = std::min(
        {costs.communication, costs.crossing, costs.switching, costs.patience, costs.waking, costs.oversleeping});
    if (costs.clock_hz <= 0 || least < Cycles{0})
        throw std::logic_error("core " + this->name() +
                               ": its clock frequency must be positive, and no cost may be negative");
}

Time ComputerCore::time_busy() const { return works_ && turn_.scheduled() ? busy_ + (kernel_.now() - began_) : busy_; }

bool ComputerCore::begin_computing(Process& self, Cycles cycles, const CodeShape&) {
    if (cycles < Cycles{0})
        throw std::logic_error("process " + self.path() + " computes for a negative number of cycles");
    if (cycles == Cycles{0})
        return true;
    began_ = kernel_.now();
    works_ = true;
    if (TraceSink* trace = kernel_.trace())
        trace->turns(self, Activity::computing, began_);
    const Time end = later(began_, duration(cycles));
    if (kernel_.pass_time(end))
        return end_work(), true;
    kernel_.future().schedule(turn_, end, EventQueue::turn);
    return false;
}

void ComputerCore::end_work() {
    works_ = false;
    busy_ += kernel_.now() - began_;
    if (TraceSink* trace = kernel_.trace())
        trace->turns(*current_, Activity::ready, kernel_.now());
}

/// Ends a computation or a switch: the current process continues.
void ComputerCore::end_turn() {
    if (works_)
        end_work();
    kernel_.enqueue(*current_);
}

void ComputerCore::make_ready(Process& p) {
    (is_woken_ ? woken_ : ready_).push_back(p);
    if (!current_)
        take_next();
}

void ComputerCore::leave(Process&, Process* successor) {
    current_ = nullptr;
    idle_since_ = kernel_.now();
    if (successor)
        make_ready(*successor);
    else
        take_next();
}

/// Returns how long the core's thread still sleeps, if it sleeps in pauses. `waited`: how long the core has had nothing
/// to do so far.
Time ComputerCore::rest_of_pause(Time waited) const {
    Time end = duration(core_.patience);
    while (end < waited)
        end += pause_after(end) + duration(core_.oversleeping);
    return end - waited;
}

Time ComputerCore::time_to_start() const {
    const Time waited = kernel_.now() - idle_since_;
    if (waited <= duration(core_.patience))
        return duration(core_.switching);
    const bool pauses = core_.oversleeping > Cycles{0} && is_woken_;
    return duration(core_.switching) + duration(core_.waking) + (pauses ? rest_of_pause(waited) : Time{});
}

void ComputerCore::take_next() {
    current_ = turns_.next(woken_, !ready_.empty());
    if (!current_)
        current_ = kernel_.take_next(ready_);
    if (!current_)
        return;
    if (const Time start = time_to_start(); start > Time{})
        kernel_.future().schedule(turn_, later(kernel_.now(), start), EventQueue::turn);
    else
        kernel_.enqueue(*current_);
}

bool CoreLane::message_waits(const AnyChannel& channel) const {
    const auto transfer = transfers_.find(&channel);
    return transfer != transfers_.end() && transfer->second.is_full;
}

void CoreLane::output(AnyChannel& channel, const WireForm& form, const SourceLocation& where) {
    charge(kernel_.running(), &OperationCosts::hard_communication);
    Transfer& transfer = transfers_[&channel];
    transfer.bytes = form.total();
    turn(true, transfer);
    to_.wake_by([&] { channel.announce(); });
    wait_until(false, transfer, channel, where);
}

void CoreLane::input(AnyChannel& channel, const SourceLocation& where) {
    charge(kernel_.running(), &OperationCosts::hard_communication);
    Transfer& transfer = transfers_[&channel];
    wait_until(true, transfer, channel, where);
    const WideInteger cycles = WideInteger{transfer.bytes} * to_.clock_hz() / bytes_per_second_;
    compute(Cycles{static_cast<std::int64_t>(std::min(cycles, WideInteger{std::numeric_limits<std::int64_t>::max()}))});
    channel.hand_over();
    turn(false, transfer);
}

void CoreLane::wait_until(bool full, Transfer& transfer, const AnyChannel& channel, const SourceLocation& where) {
    if (transfer.is_full == full)
        return;
    transfer.waiting = &kernel_.running();
    transfer.waiting->wait_for(full ? Activity::inputting : Activity::outputting, &channel, where);
}

void CoreLane::turn(bool full, Transfer& transfer) {
    transfer.is_full = full;
    if (Process* process = std::exchange(transfer.waiting, nullptr))
        static_cast<ComputerCore&>(*process->executive()).wake_by([&] { kernel_.make_ready(*process); });
}

} // namespace placedpar::hardware
