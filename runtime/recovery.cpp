#include "runtime/recovery.hpp"

#include "runtime/executive.hpp"
#include "runtime/kernel.hpp"
#include "runtime/replay_log.hpp"

#include <algorithm>

namespace placedpar {

namespace {

/// Begins an operation that a process cannot repeat from its history, because it depends on whether a message comes in
/// time.
Process& begin_attempt(Kernel& kernel) {
    Process& self = kernel.running();
    if (ReplayLog* history = kernel.begin_operation(self))
        history->record_unrepeatable();
    return self;
}

} // namespace

Attempt::Attempt(AnyChannel& channel, End end) : channel_(channel), end_(end), process_(begin_attempt(Kernel::here())) {
    charge(process_, &OperationCosts::attempt);
    end_ == End::output ? channel_.attempt_output(this) : channel_.attempt_input(this);
    process_.may_give_up(true);
}

Attempt::~Attempt() {
    process_.may_give_up(false);
    end_ == End::output ? channel_.attempt_output(nullptr) : channel_.attempt_input(nullptr);
    if (failure_)
        failure_->disable();
}

void Attempt::until_told_by(AnyChannel& failure) {
    failure.own_input(process_);
    failure_ = &failure;
}

/// Schedules the time-out, or enables the failure channel. If the time-out is already over, or a message already waits
/// on the failure channel, the attempt fails only after all other events of the current time.
void Attempt::entered() {
    EventQueue& future = process_.kernel().future();
    Time now = process_.kernel().now();
    if (deadline_)
        return future.schedule(*this, std::max(*deadline_, now), EventQueue::timer);
    failure_->enable(*this);
    if (failure_->message_waits())
        future.schedule(*this, now, EventQueue::timer);
}

void Attempt::message_announced() {
    if (!scheduled() && !failed_)
        process_.kernel().future().schedule(*this, process_.kernel().now(), EventQueue::timer);
}

void Attempt::happen() noexcept {
    if (failure_ && !failure_->message_waits())
        return; // the message on the failure channel was given up
    failed_ = end_ == End::output ? channel_.give_up_output() : channel_.give_up_input();
}

std::uint64_t reset(AnyChannel& channel, Attempt::End end) {
    charge(begin_attempt(Kernel::here()), &OperationCosts::reset_channel);
    return end == Attempt::End::output ? channel.reset_output() : channel.reset_input();
}

} // namespace placedpar
