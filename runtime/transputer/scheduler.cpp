#include "runtime/hardware/instructions.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/transputer/communication.hpp"
#include "runtime/transputer/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <tuple>
#include <utility>

namespace placedpar::transputer {
namespace {

/// The cycles of a typical interrupt (published), and of the return from an interrupt (our choice).
constexpr HalfCycles interrupt_cycles = 19, return_cycles = 17;
static_assert(interrupt_cycles == static_cast<HalfCycles>(hardware::instructions::preemption));

constexpr HalfCycles never = std::numeric_limits<HalfCycles>::max();
CodeTiming code_timing(Model model, const CoreTiming& timing) {
    const auto more = static_cast<HalfCycles16>(timing.memory_cycles - 1);
    return {model, traits_of(model).bytes_on_chip, more, static_cast<HalfCycles16>(2 * more)};
}

/// Returns whether an interrupt can happen before the end of the instruction.
bool can_be_interrupted(Operation operation) {
    switch (operation) {
    case Operation::move:
    case Operation::in:
    case Operation::out:
    case Operation::move2dall:
    case Operation::move2dnonzero:
    case Operation::move2dzero: return true;
    default: return false;
    }
}

/// Returns whether perform_at_once() can perform this instruction of the scheduler, because the instruction uses no
/// clock.
bool stays_on_processor(Operation operation) {
    switch (operation) {
    case Operation::enbc:
    case Operation::altwt:
    case Operation::disc:
    case Operation::startp:
    case Operation::endp:
    case Operation::runp:
    case Operation::stopp:
    case Operation::move: return true;
    default: return false;
    }
}

} // namespace

Core::Core(Model model, std::uint64_t memory_bytes, const CoreTiming& timing, LinkEngines& links)
    : model_(model), traits_(traits_of(model)), timing_(timing), memory_(memory_bytes, traits_.bytes_on_chip),
      code_(memory_, code_timing(model, timing)), links_(links), half_cycles_(2 * timing.clock_hz),
      penalty_(2 * static_cast<HalfCycles>(timing.memory_cycles - 1)),
      switch_(2 * static_cast<HalfCycles>(timing.switch_cycles)) {
    for (Word address = most_negative; address < most_negative + traits_.memory_start; address += 4)
        store(address, not_a_process);
    begin_slice();
    find_due();
}

Core::Pause Core::run(HalfCycles limit, Links links) {
    on_time_at_ = local_;
    Pause pause{};
    for (;;) {
        if (stopped_ != Stopped::nothing)
            return Pause::stopped;
        if (local_ >= limit)
            return Pause::limit;
        if (local_ >= due_) {
            if (links != Links::rest && local_ != on_time_at_)
                return Pause::limit;
            attend();
            continue; // the core may have stopped
        }
        if (is_analysed_ && !running_) {
            fault(Stopped::by_analyse, 0);
            return Pause::stopped;
        }
        if (priority_ == 1 && running_ && front_[0] != not_a_process &&
            (!pending_ || can_be_interrupted(pending_->operation)))
            interrupt();
        const bool has_process = running_ || dispatch();
        if (stopped_ != Stopped::nothing)
            return Pause::stopped;
        if (!has_process)
            return Pause::idle;
        if (local_ >= std::min(limit, due_))
            continue; // an interrupt, or the return from an interrupt, took the remaining time
        if (pending_) {
            if (!finish_pending(limit, links, pause))
                return pause;
            continue;
        }
        if (watcher_ends_run())
            return Pause::left;
        execute_until(std::min(limit, due_), links != Links::may_wake && !is_watched() && !is_analysed_);
    }
}

/// Tells the watcher, if there is one, which instruction begins. Returns whether the watcher ends the run.
bool Core::watcher_ends_run() {
    if (!watcher_)
        return false;
    watcher_->begins(registers_.instruction);
    return watcher_->ends_run();
}

/// Executes up to a local time, or one instruction if instructions are watched. `at_once`: instructions of the
/// scheduler may be performed before virtual time has reached their ends, if they affect only this processor.
void Core::execute_until(HalfCycles until, bool at_once) {
    if (!watcher_)
        return act_on(execute(until, at_once));
    const Word at = registers_.instruction;
    const HalfCycles began = local_;
    const Left left = execute(local_ + 1, false);
    act_on(left);
    if (left == Left::scheduling) {
        pending_->at = at;
        pending_->spent = local_ - began;
    } else if (left == Left::budget || left == Left::timeslice || left == Left::halt) {
        watcher_->executed(at, local_ - began);
    }
}

void Core::act_on(Left left) {
    switch (left) {
    case Left::budget:
    case Left::performed: break;
    case Left::scheduling: pending_ = Pending{begun_, 0, false}; break;
    case Left::timeslice:
        if (is_analysed_)
            fault(Stopped::by_analyse, 0);
        else
            pending_ = Pending{Operation::go_on, 0};
        break;
    case Left::halt: fault(Stopped::by_error, registers_.instruction); break;
    case Left::unknown:
    case Left::unknown_selector: fault(Stopped::by_unknown_instruction, stopped_at_); break;
    case Left::bad_address: fault(Stopped::by_bad_address, stopped_at_); break;
    }
}

/// Lets the cycles of an instruction pass, then performs it. Returns false if the run must pause.
bool Core::finish_pending(HalfCycles limit, Links links, Pause& pause) {
    if (!pending_->begun) {
        if (local_ != on_time_at_ && must_begin_on_time(pending_->operation, links)) {
            pause = Pause::on_time;
            return false;
        }
        pending_->begun = true;
        pending_->left = cost_of(pending_->operation);
        pending_->spent += pending_->left;
        if (stopped_ != Stopped::nothing)
            return true;
    }
    const HalfCycles room = std::min(limit, due_) - local_;
    if (pending_->left >= room) { // a timer or the limit comes before the effect of the instruction
        local_ += room;
        pending_->left -= room;
        pause = Pause::limit;
        return local_ < limit;
    }
    local_ += std::exchange(pending_->left, 0);
    if (local_ != on_time_at_ && must_be_on_time(pending_->operation, links)) {
        pause = Pause::on_time;
        return false;
    }
    const Operation operation = pending_->operation;
    const bool acts_on_link = concerns_link(operation);
    const HalfCycles due = due_;
    if (watcher_ && operation != Operation::go_on)
        watcher_->executed(pending_->at, pending_->spent);
    pending_.reset();
    perform(operation);
    pause = Pause::on_time; // returned if the caller must compute its limit again
    return !acts_on_link && (due_ >= due || links == Links::rest);
}

Core::Left Core::perform_at_once(Operation operation, Registers& r, HalfCycles until) {
    if (!stays_on_processor(operation))
        return Left::scheduling;
    registers_ = r;
    const HalfCycles ends = local_ + cost_of(operation);
    if (concerns_link(operation) || ends + switch_ >= until || stopped_ != Stopped::nothing)
        return Left::scheduling;
    local_ = ends;
    perform(operation);
    r = registers_;
    return switch_at_once(running_, r);
}

/// Returns whether the cycles of an instruction depend on what links do, or on clocks.
bool Core::must_begin_on_time(Operation operation, Links links) const {
    switch (operation) {
    case Operation::enbc: return concerns_link(operation);
    case Operation::altwt: return links == Links::may_wake;
    case Operation::taltwt:
    case Operation::tin: return links != Links::rest;
    default: return false;
    }
}

bool Core::concerns_link(Operation operation) const {
    switch (operation) {
    case Operation::in:
    case Operation::out:
    case Operation::outbyte:
    case Operation::outword:
    case Operation::enbc: return hard_channel(registers_.b) >= 0;
    case Operation::disc: return hard_channel(registers_.c) >= 0;
    case Operation::resetch: return hard_channel(registers_.a) >= 0;
    default: return false;
    }
}

bool Core::must_be_on_time(Operation operation, Links links) const {
    switch (operation) {
    case Operation::move:
    case Operation::move2dall:
    case Operation::move2dnonzero:
    case Operation::move2dzero: return false;
    case Operation::ldtimer:
    case Operation::tin:
    case Operation::taltwt:
    case Operation::sttimer:
    case Operation::timerdisableh:
    case Operation::timerdisablel:
    case Operation::timerenableh:
    case Operation::timerenablel: return links != Links::rest;
    default: return links == Links::may_wake || concerns_link(operation);
    }
}

HalfCycles Core::half_cycle_at(Time time) const {
    if (time <= origin_)
        return 0;
    constexpr WideInteger second = 1'000'000'000'000;
    const WideInteger guess = WideInteger{(time - origin_).count()} * half_cycles_.hertz() / second;
    if (guess > std::numeric_limits<std::int64_t>::max())
        return never;
    auto result = static_cast<HalfCycles>(guess);
    while (time_at(result) < time)
        ++result;
    return result;
}

void Core::pass_idle_time(Time now) {
    const HalfCycles passed = half_cycle_at(now);
    busy_before_ += local_;
    fpu_free_ = fpu_free_ > passed ? fpu_free_ - passed : 0;
    local_ = 0;
    origin_ = now;
    begin_slice();
    find_due();
}

void Core::lose_accesses(std::uint64_t words) {
    const HalfCycles lost = 2 * words * static_cast<std::uint64_t>(timing_.memory_cycles);
    local_ += lost;
    fpu_free_ += lost; // our choice: the floating-point unit waits, too; otherwise the moment of this call would matter
}

/// Attends to timers that are due and to the end of a timeslice period.
void Core::attend() {
    const Time now = local_time();
    if (now >= slice_ends_) {
        ++slices_seen_;
        begin_slice();
    }
    if (next_timer_ <= now) {
        wake_timers(0);
        wake_timers(1);
        find_next_timer();
    }
    find_due();
    due_ = std::max(due_, local_ + 1);
}

void Core::begin_slice() {
    const Time now = local_time();
    slice_ends_ = now - now % hardware::Processor::timeslice + hardware::Processor::timeslice;
}

void Core::find_due() { due_ = half_cycle_at(std::min(next_timer_, slice_ends_)); }

bool Core::waits_for_links() const {
    for (Word channel = 0; channel < hard_channels - 1; ++channel)
        if (memory_.word(4 * channel) != not_a_process)
            return true;
    return false;
}

bool Core::may_be_interrupted() const {
    if (running_ && priority_ == 1 && slices_seen_ >= 2 && front_[1] == not_a_process && waits_for_links())
        return true;
    for (Word channel = 0; channel < hard_channels - 1; ++channel)
        if (const Word waiting = memory_.word(4 * channel); waiting != not_a_process && (waiting & 1) == 0)
            return true;
    return false;
}

// Processes

/// Runs the next process: a high-priority process, else the interrupted process, else a low-priority process.
bool Core::dispatch() {
    if (front_[0] != not_a_process) {
        run_front(0);
        return true;
    }
    // The word of the interrupted process counts only at high priority. At low priority it may be left over from before
    // an analyse.
    if (priority_ == 0 && load(reserved::saved) != not_a_process) {
        resume_interrupted();
        return true;
    }
    if (front_[1] == not_a_process)
        return false;
    run_front(1);
    return true;
}

/// Moves some ready processes to the end of their queue, at random.
[[gnu::cold, gnu::noinline]] void Core::put_off_some(std::size_t priority) {
    while (front_[priority] != back_[priority] && shuffle_->chance(0.5)) {
        const Word process = front_[priority];
        front_[priority] = load(process - below::link);
        store(back_[priority] - below::link, process);
        back_[priority] = process;
    }
}

void Core::run_front(int priority) {
    take_front(static_cast<std::size_t>(priority), registers_);
    set_priority(priority);
    running_ = true;
    tell(registers_.workspace, ProcessChange::gets_processor);
}

/// Sets the priority, and exchanges the Error flags, because each priority has its own flag.
void Core::set_priority(int priority) {
    if (priority != priority_)
        std::swap(registers_.error, other_error_);
    priority_ = priority;
}

/// Saves the running process of low priority below MemStart.
void Core::save_process() {
    const Registers& r = registers_;
    const Word saved[] = {descriptor(), r.instruction, r.a, r.b, r.c, r.error ? sign_bit : 0, 0};
    for (Word i = 0; i < std::size(saved); ++i)
        store(reserved::saved + 4 * i, saved[i]);
}

void Core::interrupt() {
    save_process();
    interrupted_fpu_ = fpu_;
    interrupted_pending_ = std::exchange(pending_, std::nullopt);
    interrupted_slices_ = slices_seen_;
    tell(registers_.workspace, ProcessChange::becomes_ready);
    local_ += 2 * interrupt_cycles;
    running_ = false;
}

void Core::resume_interrupted() {
    set_priority(1);
    registers_.workspace = load(reserved::saved) & ~Word{3};
    registers_.instruction = load(reserved::saved + 4);
    registers_.a = load(reserved::saved + 8);
    registers_.b = load(reserved::saved + 12);
    registers_.c = load(reserved::saved + 16);
    registers_.error = load(reserved::saved + 20) & sign_bit;
    store(reserved::saved, not_a_process);
    fpu_ = interrupted_fpu_;
    pending_ = std::exchange(interrupted_pending_, std::nullopt);
    slices_seen_ = interrupted_slices_;
    local_ += 2 * return_cycles;
    running_ = true;
    tell(registers_.workspace, ProcessChange::gets_processor);
}

void Core::leave_processor() {
    store_instruction(registers_);
    running_ = false;
}

void Core::stop_process() {
    leave_processor();
    tell(registers_.workspace, ProcessChange::stops);
}

void Core::stop_by_error(const ErrorNote& error) {
    constexpr std::size_t most_kept = 1000;
    stops_.resize(std::min(errors_++, most_kept));
    if (stops_.size() < most_kept)
        stops_.push_back({error, priority_, local_time()});
    stop_process();
}

void Core::give_way() {
    tell(registers_.workspace, ProcessChange::becomes_ready);
    leave_processor();
    enqueue(descriptor());
}

void Core::boot(Word code_bytes, int input_channel) {
    const Word start = most_negative + traits_.memory_start;
    registers_.a = std::exchange(registers_.instruction, start);
    registers_.b = std::exchange(registers_.workspace, (start + code_bytes + 3) & ~Word{3});
    registers_.c = most_negative + 4 * static_cast<Word>(input_channel);
    set_priority(1);
    running_ = true;
    slices_seen_ = 0;
    tell(registers_.workspace, ProcessChange::gets_processor);
}

void Core::reset_after_analyse() {
    const bool waited = stopped_ == Stopped::by_analyse && !was_running_;
    stopped_ = Stopped::nothing;
    if (priority_ == 1 && !waited)
        save_process();
    is_analysed_ = running_ = clocks_run_ = false;
    errors_ = 0;
    analysed_ = true;
    pending_.reset();
    find_next_timer();
}

void Core::end_process() {
    const Word count = load(registers_.a + 4);
    store(registers_.a + 4, count - 1);
    tell(registers_.workspace, ProcessChange::ends);
    running_ = false;
    if (count != 1)
        return;
    registers_.workspace = registers_.a & ~Word{3};
    registers_.instruction = load(registers_.workspace);
    running_ = true;
    tell(registers_.workspace, ProcessChange::gets_processor);
}

} // namespace placedpar::transputer
