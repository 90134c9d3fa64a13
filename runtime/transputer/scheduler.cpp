#include "runtime/hardware/instructions.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/transputer/core.hpp"
#include "runtime/transputer/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <tuple>
#include <utility>

namespace placedpar::transputer {
namespace {

/// The cycles of an interrupt, typically (published), and of the return from it (ours).
constexpr HalfCycles interrupt_cycles = 19, return_cycles = 17;
static_assert(interrupt_cycles == static_cast<HalfCycles>(hardware::instructions::preemption));

constexpr HalfCycles never = std::numeric_limits<HalfCycles>::max();
constexpr int hard_channels = 9;

/// Returns the number of a link's channel: 0 to 3 outputs, 4 to 7 inputs, 8 the event channel; otherwise -1.
int hard_channel(Word address) {
    const Word offset = NodeMemory::offset_of(address);
    return offset < 4 * hard_channels ? static_cast<int>(offset / 4) : -1;
}

CodeTiming code_timing(Model model, const CoreTiming& timing) {
    const auto more = static_cast<HalfCycles16>(timing.memory_cycles - 1);
    return {model, traits_of(model).bytes_on_chip, more, static_cast<HalfCycles16>(2 * more)};
}

/// Returns whether an interrupt need not wait for the end of the instruction.
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

} // namespace

Core::Core(Model model, std::uint64_t memory_bytes, const CoreTiming& timing, LinkEngines& links)
    : model_(model), traits_(traits_of(model)), timing_(timing), memory_(memory_bytes),
      code_(memory_, code_timing(model, timing)), links_(links), half_cycles_(2 * timing.clock_hz),
      penalty_(2 * static_cast<HalfCycles>(timing.memory_cycles - 1)) {
    for (Word address = most_negative; address < most_negative + traits_.memory_start; address += 4)
        store(address, not_a_process);
    begin_slice();
    find_due();
}

Core::Pause Core::run(HalfCycles limit, bool punctual) {
    on_time_at_ = local_;
    Pause pause{};
    for (;;) {
        if (stopped_ != Stopped::nothing)
            return Pause::stopped;
        if (local_ >= due_) {
            if (memory_is_shared_ && local_ != on_time_at_)
                return Pause::limit;
            attend();
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
        if (local_ >= due_)
            continue; // an interrupt or return took the time until a timer
        if (pending_) {
            if (!finish_pending(limit, punctual, pause))
                return pause;
            continue;
        }
        if (local_ >= limit)
            return Pause::limit;
        execute_until(std::min(limit, due_));
    }
}

/// Executes up to a local time, or one instruction if they are watched.
void Core::execute_until(HalfCycles until) {
    if (!watcher_)
        return act_on(execute(until - local_));
    const Word at = registers_.instruction;
    const HalfCycles began = local_;
    watcher_->begins(at);
    const Left left = execute(1);
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
    case Left::budget: break;
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
bool Core::finish_pending(HalfCycles limit, bool punctual, Pause& pause) {
    if (!pending_->begun) {
        if (local_ != on_time_at_ && must_begin_on_time(pending_->operation, punctual)) {
            pause = Pause::on_time;
            return false;
        }
        pending_->begun = true;
        pending_->left = cost_of(pending_->operation);
        pending_->spent += pending_->left;
        if (stopped_ != Stopped::nothing)
            return true;
    }
    const HalfCycles until = std::min(limit, due_);
    const HalfCycles room = until > local_ ? until - local_ : 0;
    const bool timer_first = pending_->left > 0 && local_ + pending_->left == due_;
    if (pending_->left > room || timer_first) {
        local_ += room;
        pending_->left -= room;
        pause = Pause::limit;
        return local_ < limit;
    }
    local_ += std::exchange(pending_->left, 0);
    if (local_ != on_time_at_ && must_be_on_time(pending_->operation, punctual)) {
        pause = Pause::on_time;
        return false;
    }
    const Operation operation = pending_->operation;
    const bool link = concerns_link(operation);
    const HalfCycles due = due_;
    if (watcher_ && operation != Operation::go_on)
        watcher_->executed(pending_->at, pending_->spent);
    pending_.reset();
    perform(operation);
    pause = Pause::on_time; // if the caller's limit may be too late now
    return !link && (due_ >= due || !memory_is_shared_);
}

/// Returns whether the cycles of an instruction depend on what links do, or on clocks.
bool Core::must_begin_on_time(Operation operation, bool punctual) const {
    switch (operation) {
    case Operation::enbc: return concerns_link(operation);
    case Operation::altwt: return punctual;
    case Operation::taltwt:
    case Operation::tin: return punctual || memory_is_shared_;
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

bool Core::must_be_on_time(Operation operation, bool punctual) const {
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
    case Operation::timerenablel: return punctual || memory_is_shared_;
    default: return punctual || concerns_link(operation);
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
    fpu_free_ += lost; // ours: the floating-point unit waits, too; otherwise the moment of this call would matter
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

/// Takes the next process: of high priority, the interrupted one, or of low priority.
bool Core::dispatch() {
    if (front_[0] != not_a_process) {
        take_front(0);
        return true;
    }
    if (priority_ == 0 && load(reserved::saved) != not_a_process) { // after analyse the word may be an old one
        resume_interrupted();
        return true;
    }
    if (front_[1] == not_a_process)
        return false;
    take_front(1);
    return true;
}

void Core::take_front(int priority) {
    const auto p = static_cast<std::size_t>(priority);
    const Word workspace = front_[p];
    front_[p] = workspace == back_[p] ? not_a_process : load(workspace - below::link);
    local_ += 2 * static_cast<HalfCycles>(timing_.switch_cycles);
    continue_at(workspace, priority);
}

void Core::continue_at(Word workspace, int priority) {
    registers_.workspace = workspace;
    registers_.instruction = load(workspace - below::instruction);
    set_priority(priority);
    running_ = true;
    slices_seen_ = 0;
}

/// Each priority has its own Error flag.
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
}

/// Stores where the running process goes on, and takes it off the processor.
void Core::leave_processor() {
    store(registers_.workspace - below::instruction, registers_.instruction);
    running_ = false;
}

void Core::give_way() {
    leave_processor();
    enqueue(descriptor());
}

void Core::enqueue(Word process) {
    const Word workspace = process & ~Word{3};
    const std::size_t priority = process & 1;
    if (front_[priority] == not_a_process)
        front_[priority] = workspace;
    else
        store(back_[priority] - below::link, workspace);
    back_[priority] = workspace;
}

void Core::boot(Word code_bytes, int input_channel) {
    const Word start = most_negative + traits_.memory_start;
    registers_.a = std::exchange(registers_.instruction, start);
    registers_.b = std::exchange(registers_.workspace, (start + code_bytes + 3) & ~Word{3});
    registers_.c = most_negative + 4 * static_cast<Word>(input_channel);
    set_priority(1);
    running_ = true;
    slices_seen_ = 0;
}

void Core::reset_after_analyse() {
    const bool waited = stopped_ == Stopped::by_analyse && !was_running_;
    stopped_ = Stopped::nothing;
    if (priority_ == 1 && !waited)
        save_process();
    is_analysed_ = running_ = clocks_run_ = false;
    analysed_ = true;
    pending_.reset();
    find_next_timer();
}

void Core::end_process() {
    const Word count = load(registers_.a + 4);
    store(registers_.a + 4, count - 1);
    running_ = false;
    if (count != 1)
        return;
    registers_.workspace = registers_.a & ~Word{3};
    registers_.instruction = load(registers_.workspace);
    running_ = true;
}

// Channels

void Core::transfer_ended(int channel) {
    const Word address = most_negative + 4 * static_cast<Word>(channel);
    const Word process = load(address);
    store(address, not_a_process);
    if (process != not_a_process)
        enqueue(process);
}

void Core::wait_at(Word channel, Word address) {
    store(channel, descriptor());
    store(registers_.workspace - below::pointer, address);
    leave_processor();
}

/// Performs an input or output of bytes.
void Core::communicate(Word channel, Word address, Word bytes, bool output) {
    if (const int hard = hard_channel(channel); hard >= 0) {
        if (bytes == 0 && hard < hard_channels - 1)
            return;
        if (!memory_.holds(NodeMemory::offset_of(address), bytes))
            return fault(Stopped::by_bad_address, address);
        store(channel, descriptor());
        leave_processor();
        links_.begin_transfer(hard, address, bytes);
        return;
    }
    const Word partner = load(channel);
    if (partner == not_a_process)
        wait_at(channel, address);
    else
        meet(channel, partner, address, bytes, output);
}

void Core::meet(Word channel, Word partner, Word address, Word bytes, bool output) {
    const Word other = load((partner & ~Word{3}) - below::pointer);
    const bool in_alternative =
        other == alternative::enabling || other == alternative::waiting || other == alternative::ready;
    if (output && in_alternative) {
        wake_alternative(partner, local_time());
        wait_at(channel, address);
        return;
    }
    move_block(output ? address : other, output ? other : address, bytes);
    store(channel, not_a_process);
    enqueue(partner);
}

/// Tells a process in an ALT that one of its channels is ready.
void Core::wake_alternative(Word partner, Time now) {
    const Word workspace = partner & ~Word{3};
    const Word state = load(workspace - below::state);
    store(workspace - below::state, alternative::ready);
    if (state != alternative::waiting)
        return;
    leave_timers(workspace, static_cast<int>(partner & 1), now);
    enqueue(partner);
}

void Core::byte_has_come(int channel, Time now) {
    if (const Word waiting = load(most_negative + 4 * static_cast<Word>(channel)); waiting != not_a_process)
        wake_alternative(waiting, now);
}

void Core::reset_channel() {
    const Word channel = registers_.a;
    registers_.a = load(channel);
    store(channel, not_a_process);
    if (const int hard = hard_channel(channel); hard >= 0)
        links_.reset(hard);
}

// Instructions of the scheduler

HalfCycles Core::cost_of_communication(Word channel, Word address, Word bytes) {
    constexpr HalfCycles waits = 2 * 19;
    if (hard_channel(channel) >= 0)
        return waits;
    const Word partner = load(channel);
    if (partner == not_a_process)
        return waits;
    const Word other = load((partner & ~Word{3}) - below::pointer);
    if (other == alternative::enabling || other == alternative::waiting || other == alternative::ready)
        return waits;
    return waits + 4 * words_touched(address, bytes) + outside_words(address, bytes) + outside_words(other, bytes);
}

HalfCycles Core::cost_of(Operation operation) {
    const Registers& r = registers_;
    const HalfCycles cycles = 2 * static_cast<HalfCycles>(cycles_of(operation, model_));
    switch (operation) {
    case Operation::in:
    case Operation::out: return cost_of_communication(r.b, r.c, r.a);
    case Operation::outbyte:
    case Operation::outword: {
        const bool second = hard_channel(r.b) >= 0 || cost_of_communication(r.b, r.workspace, 4) > 2 * 19;
        return cycles - (second ? 0 : 4);
    }
    case Operation::move:
        return cycles + 4 * words_touched(r.c, r.a) + outside_words(r.c, r.a) + outside_words(r.b, r.a);
    case Operation::move2dall:
    case Operation::move2dnonzero:
    case Operation::move2dzero:
        return move_[0] * (cycles + 4 * words_touched(r.c, r.a) + outside_words(r.c, r.a) + outside_words(r.b, r.a));
    case Operation::enbc: return cycles + (r.a != 0 && is_ready(r.b) ? 4 : 0);
    case Operation::altwt: return load(r.workspace - below::state) == alternative::ready ? cycles : 2 * 17;
    case Operation::taltwt: return time_has_come() ? cycles : 2 * 48;
    case Operation::tin: return signed_of(clock(priority_) - r.a) > 0 ? cycles : 2 * 30;
    case Operation::go_on: return 0;
    default: return cycles;
    }
}

void Core::perform(Operation operation) {
    Registers& r = registers_;
    switch (operation) {
    case Operation::in: communicate(r.b, r.c, r.a, false); break;
    case Operation::out: communicate(r.b, r.c, r.a, true); break;
    case Operation::outbyte:
    case Operation::outword:
        store(r.workspace, r.a);
        communicate(r.b, r.workspace, operation == Operation::outword ? 4 : 1, true);
        break;
    case Operation::resetch: reset_channel(); break;
    case Operation::enbc: enable_channel(); break;
    case Operation::enbt: enable_timer(); break;
    case Operation::altwt: wait_for_alternative(false); break;
    case Operation::taltwt: wait_for_alternative(true); break;
    case Operation::disc: disable_channel(); break;
    case Operation::dist: disable_timer(); break;
    case Operation::ldtimer: push(clock(priority_)); break;
    case Operation::tin: wait_for_time(); break;
    case Operation::sttimer: start_clocks(r.a); break;
    case Operation::startp:
        store(r.a - below::instruction, r.instruction + r.b);
        enqueue((r.a & ~Word{3}) | static_cast<Word>(priority_));
        r.a = r.b = r.c;
        break;
    case Operation::endp: end_process(); break;
    case Operation::runp:
        enqueue(r.a);
        pop();
        break;
    case Operation::stopp: leave_processor(); break;
    case Operation::stoperr:
        if (r.error)
            leave_processor();
        break;
    case Operation::go_on: give_way(); break;
    case Operation::saveh:
    case Operation::savel: {
        const std::size_t queue = operation == Operation::savel;
        store(r.a, front_[queue]);
        store(r.a + 4, back_[queue]);
        pop();
        break;
    }
    case Operation::sthf:
        front_[0] = r.a;
        pop();
        break;
    case Operation::sthb:
        back_[0] = r.a;
        pop();
        break;
    case Operation::stlf:
        front_[1] = r.a;
        pop();
        break;
    case Operation::stlb:
        back_[1] = r.a;
        pop();
        break;
    case Operation::timerdisableh:
        timers_disabled_[0] = true;
        find_next_timer();
        break;
    case Operation::timerdisablel:
        timers_disabled_[1] = true;
        find_next_timer();
        break;
    case Operation::timerenableh:
        timers_disabled_[0] = false;
        find_next_timer();
        break;
    case Operation::timerenablel:
        timers_disabled_[1] = false;
        find_next_timer();
        break;
    case Operation::break_: fault(Stopped::by_break, r.instruction); break;
    case Operation::move: move_block(r.c, r.b, r.a); break;
    default: move_in_two_dimensions(operation); break;
    }
}

// Memory

Word Core::load(Word address) {
    const Word offset = NodeMemory::offset_of(address) & ~Word{3};
    if (!memory_.holds(offset, 4)) {
        fault(Stopped::by_bad_address, address);
        return not_a_process;
    }
    return memory_.word(offset);
}

void Core::store(Word address, Word value) {
    const Word offset = NodeMemory::offset_of(address) & ~Word{3};
    if (!memory_.holds(offset, 4))
        fault(Stopped::by_bad_address, address);
    else
        write(offset, {reinterpret_cast<const std::uint8_t*>(&value), 4});
}

void Core::write(Word offset, std::span<const std::uint8_t> bytes) {
    if (bytes.empty())
        return;
    const auto count = static_cast<Word>(bytes.size());
    std::memmove(memory_.data() + offset, bytes.data(), bytes.size());
    if (memory_.has_code(offset, count))
        code_.forget(offset, count);
}

void Core::copy_from_memory(Word offset, std::span<std::uint8_t> to) {
    const auto bytes = static_cast<Word>(to.size());
    if (memory_.holds(offset, bytes))
        std::ranges::copy(memory_.bytes(offset, bytes), to.begin());
    else
        fault(Stopped::by_bad_address, most_negative + offset);
}

void Core::copy_to_memory(Word offset, std::span<const std::uint8_t> bytes) {
    if (memory_.holds(offset, static_cast<Word>(bytes.size())))
        write(offset, bytes);
    else
        fault(Stopped::by_bad_address, most_negative + offset);
}

/// Returns the number of words that an interval touches, with part words at its ends.
HalfCycles Core::words_touched(Word address, Word bytes) {
    return bytes == 0 ? 0 : ((HalfCycles{address} & 3) + bytes + 3) / 4;
}

/// Returns the half cycles that a copy takes longer since this end of it is outside of the chip.
HalfCycles Core::outside_words(Word address, Word bytes) const {
    return NodeMemory::offset_of(address) < traits_.bytes_on_chip ? 0 : words_touched(address, bytes) * penalty_;
}

void Core::move_block(Word from, Word to, Word bytes) {
    const Word source = NodeMemory::offset_of(from), target = NodeMemory::offset_of(to);
    if (bytes == 0) // programs move nothing from or to address 0
        return;
    if (!memory_.holds(source, bytes))
        fault(Stopped::by_bad_address, from);
    else if (!memory_.holds(target, bytes))
        fault(Stopped::by_bad_address, to);
    else
        write(target, memory_.bytes(source, bytes));
}

/// Moves rows of bytes: all, those that are not 0, or those that are 0.
void Core::move_in_two_dimensions(Operation operation) {
    const auto [width, target, source] = std::tuple{registers_.a, registers_.b, registers_.c};
    const auto [rows, target_stride, source_stride] = move_;
    for (Word row = 0; row < rows && stopped_ == Stopped::nothing; ++row) {
        const Word from = source + row * source_stride, to = target + row * target_stride;
        if (operation == Operation::move2dall) {
            move_block(from, to, width);
            continue;
        }
        for (Word i = 0; i < width && stopped_ == Stopped::nothing; ++i) {
            const Word offset = NodeMemory::offset_of(from + i);
            const bool is_zero = memory_.holds(offset, 1) && memory_.byte(offset) == 0;
            if (is_zero == (operation == Operation::move2dzero))
                move_block(from + i, to + i, 1);
        }
    }
}

// Errors

void Core::fault(Stopped why, Word address) {
    if (stopped_ != Stopped::nothing)
        return;
    stopped_ = why;
    stopped_at_ = address;
    was_running_ = std::exchange(running_, false);
}

std::string Core::why_stopped() const {
    const Word at = registers_.instruction;
    switch (stopped_) {
    case Stopped::nothing: return "";
    case Stopped::by_error:
        return fmt::format("the instruction before #{:08X} set the Error flag while HaltOnError was set", at);
    case Stopped::by_unknown_instruction:
        return fmt::format("the bytes at #{:08X} are no instruction of a {}", at, traits_.name);
    case Stopped::by_bad_address:
        return fmt::format(
            "the instruction at #{:08X} uses the address #{:08X}, but memory is from #80000000 to #{:08X}", at,
            stopped_at_, most_negative + memory_.size() - 1);
    case Stopped::by_analyse: return fmt::format("analyse has stopped it before #{:08X}", at);
    case Stopped::by_break: return fmt::format("the instruction before #{:08X} is a breakpoint", at);
    }
    return "";
}

void Core::set_registers(const Registers& registers, int priority) {
    registers_ = registers;
    priority_ = priority;
    running_ = true;
    pending_.reset();
}

} // namespace placedpar::transputer
