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

/// Returns the costs of occam's operations with this memory, including `channel_call` cycles of a library for each
/// communication. A copied word takes two accesses to the memory: a read and a write.
OperationCosts costs_with(Cycles channel_call, const Memory& memory) {
    OperationCosts costs = instructions::t800;
    costs.copied_word = 2 * memory.access;
    costs.word_outside = Cycles{static_cast<std::int64_t>(memory.access) - 1};
    costs.bytes_in_a_word = memory.bytes_in_a_word;
    costs.soft_communication = channel_call + costs.soft_communication;
    costs.soft_word_output = channel_call + costs.soft_word_output + 2 * costs.word_outside;
    costs.hard_communication = channel_call + costs.hard_communication;
    costs.reset_channel = channel_call + costs.reset_channel;
    return costs;
}

std::int64_t checked_clock(std::int64_t clock_hz, const std::string& processor) {
    if (clock_hz <= 0)
        throw std::logic_error("processor " + processor + ": its clock frequency must be positive");
    return clock_hz;
}

/// Throws std::logic_error if a number is negative, or if a member of `grain` other than `words_outside` is 0.
void require_sense(const Process& self, Cycles cycles, const CodeShape& grain) {
    if (cycles < Cycles{0})
        throw std::logic_error("process " + self.path() + " computes for a negative number of cycles");
    if (grain.between_points < Cycles{1} || grain.instruction < Cycles{1})
        throw std::logic_error(
            "process " + self.path() +
            " computes with a CodeShape whose `between_points` or `instruction` is less than one cycle");
    if (grain.words_outside < 0)
        throw std::logic_error("process " + self.path() + " computes with a negative number of words outside the chip");
}

} // namespace

Processor::Processor(Kernel& kernel, std::string name, std::int64_t clock_hz, Cycles channel_call, const Memory& memory,
                     Cycles switching)
    : Executive(std::move(name), costs_with(channel_call, memory)),
      kernel_(kernel), engines_{.bytes_in_a_word = static_cast<std::uint32_t>(memory.bytes_in_a_word)},
      clock_(checked_clock(clock_hz, this->name())) {
    if (memory.access < Cycles{1} || (memory.bytes_in_a_word != 2 && memory.bytes_in_a_word != 4))
        throw std::logic_error(
            "processor " + this->name() +
            ": an access to its memory must take at least one cycle, and a word must have 2 or 4 bytes");
    if (switching < Cycles{0})
        throw std::logic_error("processor " + this->name() + ": the cycles of a process switch must not be negative");
    access_ = duration(memory.access);
    switching_ = duration(switching);
}

void Processor::has_link(Link& link) {
    link.from_a_to_b().move_messages_of(engines_);
    link.from_b_to_a().move_messages_of(engines_);
    links_.push_back(&link);
}

bool Processor::halted() const { return kernel_.now() >= halts_at_; }

Time Processor::memory_taken_by_links() { return times(words_moved_by_links(), access_); }

std::int64_t Processor::words_moved_by_links() {
    bool known = counted_at_ == kernel_.now() && ended_when_counted_ == engines_.words_of_ended_parts;
    if (!known) {
        counted_at_ = kernel_.now();
        words_ = ended_when_counted_ = engines_.words_of_ended_parts;
        if (engines_.parts_under_way > 0) {
            for (Link* link : links_)
                link->fetch();
            for (Link* link : links_)
                words_ += link->words_moved(engines_, counted_at_);
        }
    }
    return static_cast<std::int64_t>(words_);
}

Time Processor::time_busy() const { return turn_.scheduled() ? busy_ + (kernel_.now() - turn_began_) : busy_; }

void Processor::make_ready(Process& p) {
    (p.priority() == Priority::high ? high_ : low_).push_back(p);
    if (!current_) {
        dispatch();
    } else if (turn_.scheduled() && current_->priority() == Priority::low) {
        if (p.priority() == Priority::high) {
            preempt();
        } else { // from now on another process waits, so the timeslice of the current process matters
            settle();
            schedule_end();
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

/// Runs the successor in place of the current process.
void Processor::go_on(Process& successor) {
    current_ = &successor;
    if (successor.priority() == Priority::low && !high_.empty())
        preempt();
    else
        kernel_.enqueue(successor);
}

void Processor::switch_to(Process& next) {
    current_ = &next;
    work_left(next) = later(work_left(next), switching_);
}

void Processor::dispatch() {
    if (halted())
        return;
    if (Process* p = kernel_.take_next(high_)) {
        switch_to(*p);
    } else if (preempted_) {
        current_ = std::exchange(preempted_, nullptr);
    } else if (Process* waiting = kernel_.take_next(low_)) {
        switch_to(*waiting);
        dispatched_at_ = kernel_.now();
    } else {
        return;
    }
    if (work_left(*current_) > Time{0})
        take_turn();
    else
        kernel_.enqueue(*current_);
}

bool Processor::begin_computing(Process& self, Cycles cycles, const CodeShape& how_fine) {
    assert(current_ == &self);
    require_sense(self, cycles, how_fine);
    Cycles all = cycles + how_fine.words_outside * costs().word_outside;
    work_left(self) = later(work_left(self), duration(all));
    grain(self) = how_fine;
    if (self.priority() == Priority::low && !high_.empty()) {
        preempt();
    } else {
        begin_turn();
        bool alone = self.priority() == Priority::high || low_.empty();
        while (alone && later(kernel_.now(), work_left(self)) < halts_at_ &&
               kernel_.pass_time(later(kernel_.now(), work_left(self)))) {
            settle();
            if (work_left(self) == Time{0})
                return account(self, kernel_.now() - turn_began_), true;
        }
        schedule_end();
    }
    return false;
}

/// Returns the first end of a timeslice period at which the current process has run for a whole period.
Time Processor::end_of_slice() const {
    Time rounded_up = later(later(dispatched_at_, timeslice), timeslice - Time{1});
    return rounded_up == Time::max() ? rounded_up : rounded_up / timeslice * timeslice;
}

/// Returns the time of the next descheduling point after the end of the slice, if links do not delay the process. The
/// points are counted back from the end of the work, which is itself a descheduling point.
Time Processor::next_point_after_slice() const {
    Time over = std::max(end_of_slice(), kernel_.now());
    Time left = later(kernel_.now(), work_left(*current_)) - over;
    if (left <= Time{0})
        return Time::max();
    Time between = duration(grain(*current_).between_points), to_point = left % between;
    if (to_point == Time{0} && over == end_of_slice())
        to_point = between;
    return later(over, to_point);
}

void Processor::begin_turn() {
    turn_began_ = settled_at_ = kernel_.now();
    words_settled_ = words_moved_by_links();
    note_computing(*current_);
}

void Processor::take_turn() {
    begin_turn();
    schedule_end();
}

/// Schedules the end of the work, or an earlier end of the timeslice if other processes wait. Links that access the
/// memory delay the end of the work; settle() adds this delay when the event happens.
void Processor::schedule_end() {
    Time end = std::min(later(kernel_.now(), work_left(*current_)), halts_at_);
    if (has_low_rivals())
        end = std::min(end, next_point_after_slice());
    kernel_.future().reschedule(turn_, end, EventQueue::turn);
}

void Processor::settle() {
    if (settled_at_ == kernel_.now())
        return;
    work_left(*current_) -= kernel_.now() - std::exchange(settled_at_, kernel_.now());
    std::int64_t words = words_moved_by_links();
    if (std::int64_t moved = words - std::exchange(words_settled_, words))
        work_left(*current_) = later(work_left(*current_), times(moved, access_));
}

void Processor::stop_turn() {
    settle();
    account(*current_, kernel_.now() - turn_began_);
    kernel_.future().cancel(turn_);
}

bool Processor::has_low_rivals() const { return current_->priority() == Priority::low && !low_.empty(); }

/// Returns whether a low-priority process that has work left must give way to another process now.
bool Processor::gives_way() const { return has_low_rivals() && next_point_after_slice() == kernel_.now(); }

void Processor::note_computing(const Process& process) const {
    if (TraceSink* trace = kernel_.trace())
        trace->turns(process, Activity::computing, turn_began_);
}

void Processor::account(const Process& process, Time worked) {
    busy_ += worked;
    if (TraceSink* trace = kernel_.trace())
        trace->turns(process, Activity::ready, kernel_.now());
}

void Processor::end_turn() {
    settle();
    if (halted())
        return stop_turn();
    bool unfinished = work_left(*current_) > Time{0};
    if (unfinished && !gives_way())
        return schedule_end();
    stop_turn();
    if (unfinished) {
        low_.push_back(*std::exchange(current_, nullptr));
        dispatch();
    } else {
        kernel_.enqueue(*current_);
    }
}

/// Interrupts a low-priority process. The first high-priority process of the queue runs instead.
void Processor::preempt() {
    if (turn_.scheduled())
        stop_turn();
    preempted_ = std::exchange(current_, nullptr);
    Process* high = kernel_.take_next(high_);
    Time rest = work_left(*preempted_) % duration(grain(*preempted_).instruction); // rest of the current instruction
    work_left(*preempted_) -= rest;
    work_left(*high) = later(work_left(*high), rest + duration(instructions::preemption));
    current_ = high;
    take_turn();
}

} // namespace placedpar::hardware
