#include "runtime/hardware/processor.hpp"

#include "runtime/hardware/instructions.hpp"
#include "runtime/kernel.hpp"
#include "runtime/trace.hpp"

#include <algorithm>
#include <cassert>
#include <stdexcept>
#include <utility>

namespace placedpar::hardware {

namespace {

/// occam's costs, and what the program's communication library adds.
OperationCosts costs_with(Cycles channel_call) {
    OperationCosts costs = instructions::t800;
    costs.soft_communication = channel_call + costs.soft_communication;
    costs.hard_communication = channel_call + costs.hard_communication;
    return costs;
}

} // namespace

Processor::Processor(Kernel& kernel, std::string name, std::int64_t clock_hz, Cycles channel_call)
    : Executive(std::move(name), costs_with(channel_call)), kernel_(kernel), clock_hz_(clock_hz) {
    if (clock_hz <= 0)
        throw std::logic_error("processor " + this->name() + ": its clock frequency must be positive");
}

Time Processor::time_busy() const { return turn_.scheduled() ? busy_ + (kernel_.now() - turn_began_) : busy_; }

void Processor::make_ready(Process& p) {
    (p.priority() == Priority::high ? high_ : low_).push_back(p);
    if (!current_) {
        dispatch();
    } else if (turn_.scheduled() && current_->priority() == Priority::low) {
        if (p.priority() == Priority::high) {
            preempt();
        } else { // the current one may have had no rival so far: now its timeslice counts
            stop_turn();
            begin_turn();
        }
    }
}

void Processor::leave(Process& p, Process* successor) {
    assert(current_ == &p);
    if (successor && successor->priority() == p.priority())
        return go_on(*successor);
    current_ = nullptr;
    dispatch();
    if (successor)
        make_ready(*successor);
}

/// In the place of the current process.
void Processor::go_on(Process& successor) {
    current_ = &successor;
    if (successor.priority() == Priority::low && !high_.empty())
        preempt();
    else
        kernel_.enqueue(successor);
}

void Processor::dispatch() {
    if (Process* p = high_.pop_front()) {
        current_ = p;
    } else if (preempted_) {
        current_ = std::exchange(preempted_, nullptr);
    } else if (Process* waiting = low_.pop_front()) {
        current_ = waiting;
        dispatched_at_ = kernel_.now();
    } else {
        return;
    }
    if (work_left(*current_) > Time{0})
        begin_turn();
    else
        kernel_.enqueue(*current_);
}

void Processor::compute(Cycles cycles) {
    Process& self = kernel_.running();
    kernel_.throw_if_unwinding();
    assert(current_ == &self);
    if (cycles < Cycles{0})
        throw std::logic_error("process " + self.path() + " computes for a negative number of cycles");
    if (cycles == Cycles{0})
        kernel_.takes_no_time();
    work_left(self) = later(work_left(self), duration(cycles));
    if (self.priority() == Priority::low && !high_.empty()) {
        preempt();
    } else {
        bool alone = self.priority() == Priority::high || low_.empty();
        if (alone && kernel_.pass_time(later(kernel_.now(), work_left(self)))) {
            turn_began_ = kernel_.now() - work_left(self);
            note_computing(self);
            account(self, std::exchange(work_left(self), Time{0}));
            return;
        }
        begin_turn();
    }
    kernel_.give_way();
}

Time Processor::duration(Cycles cycles) const { return duration_of(static_cast<std::int64_t>(cycles), clock_hz_); }

/// The end of the first timeslice period that ends with the current process having run for a whole one.
Time Processor::slice_end() const {
    Time earliest = std::max(later(dispatched_at_, timeslice), kernel_.now());
    Time rounded_up = later(earliest, timeslice - Time{1});
    return rounded_up == Time::max() ? rounded_up : rounded_up / timeslice * timeslice;
}

void Processor::begin_turn() {
    turn_began_ = kernel_.now();
    note_computing(*current_);
    Time end = later(turn_began_, work_left(*current_));
    if (current_->priority() == Priority::low && !low_.empty())
        end = std::min(end, slice_end());
    kernel_.future().schedule(turn_, end, EventQueue::turn);
}

void Processor::stop_turn() {
    Time worked = kernel_.now() - turn_began_;
    work_left(*current_) -= worked;
    account(*current_, worked);
    kernel_.future().cancel(turn_);
}

void Processor::note_computing(const Process& process) const {
    if (TraceSink* trace = kernel_.trace())
        trace->computes(process, turn_began_);
}

void Processor::account(const Process& process, Time worked) {
    busy_ += worked;
    if (TraceSink* trace = kernel_.trace())
        trace->stops_computing(process, kernel_.now());
}

void Processor::end_turn() {
    stop_turn();
    if (work_left(*current_) > Time{0}) {
        low_.push_back(*std::exchange(current_, nullptr));
        dispatch();
    } else {
        kernel_.enqueue(*current_);
    }
}

/// A high-priority process waits in the queue and a low one has the processor.
void Processor::preempt() {
    if (turn_.scheduled())
        stop_turn();
    preempted_ = std::exchange(current_, nullptr);
    Process* high = high_.pop_front();
    work_left(*high) = later(work_left(*high), duration(instructions::preemption));
    current_ = high;
    begin_turn();
}

} // namespace placedpar::hardware
