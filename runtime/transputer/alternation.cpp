#include "runtime/hardware/processor.hpp"
#include "runtime/transputer/communication.hpp"
#include "runtime/transputer/words.hpp"

#include <utility>

// This file has the instructions of ALT, clocks and timers.

namespace placedpar::transputer {
namespace {

constexpr Time tick_of(int priority) {
    return priority == 0 ? hardware::Processor::high_tick : hardware::Processor::low_tick;
}

int link_input(Word address) {
    const Word offset = NodeMemory::offset_of(address);
    return offset >= 0x10 && offset < 0x20 ? static_cast<int>(offset / 4) : -1;
}

bool is_after(Word time, Word other) { return signed_of(time - other) > 0; }

} // namespace

/// Returns whether an input from the channel would find a message.
bool Core::is_ready(Word channel) {
    if (const int link = link_input(channel); link >= 0)
        return links_.byte_waits(link);
    const Word waiting = load(channel);
    return waiting != not_a_process && waiting != descriptor();
}

void Core::enable_channel() {
    const Word channel = registers_.b;
    registers_.b = registers_.c;
    if (registers_.a == 0)
        return;
    tell(registers_.workspace, ProcessChange::enables_channel, channel);
    if (is_ready(channel))
        store(registers_.workspace - below::state, alternative::ready);
    else
        store(channel, descriptor());
}

void Core::disable_channel() {
    const Word channel = registers_.c;
    bool ready = false;
    if (registers_.b != 0) {
        ready = is_ready(channel);
        if (load(channel) == descriptor())
            store(channel, not_a_process);
    }
    select(ready);
}

/// Selects the guard of a disable instruction if it is the first ready guard. Register A holds the offset of the
/// guarded process.
void Core::select(bool ready) {
    const bool selected = ready && load(registers_.workspace) == alternative::none_selected;
    if (selected)
        store(registers_.workspace, registers_.a);
    registers_.a = selected;
}

void Core::enable_timer() {
    const Word time = registers_.b, workspace = registers_.workspace;
    registers_.b = registers_.c;
    if (registers_.a == 0)
        return;
    const bool first = load(workspace - below::timer_link) == alternative::time_not_set;
    if (first)
        store(workspace - below::timer_link, alternative::time_set);
    if (first || is_after(load(workspace - below::time), time))
        store(workspace - below::time, time);
}

void Core::disable_timer() {
    const bool ready = registers_.b != 0 && !is_after(registers_.c, load(registers_.workspace - below::time));
    select(ready);
    registers_.b = registers_.c;
}

/// Returns whether taltwt need not wait, because a guard is ready or the time has come.
bool Core::time_has_come() {
    const Word workspace = registers_.workspace;
    if (load(workspace - below::state) == alternative::ready)
        return true;
    return load(workspace - below::timer_link) == alternative::time_set &&
           !is_after(load(workspace - below::time), clock(priority_));
}

void Core::wait_for_alternative(bool timer) {
    const Word workspace = registers_.workspace;
    store(workspace, alternative::none_selected);
    const bool ready = load(workspace - below::state) == alternative::ready;
    if (ready || (timer && time_has_come())) {
        store(workspace - below::state, alternative::ready);
        if (timer)
            store(workspace - below::time, clock(priority_));
        tell(workspace, ProcessChange::needs_no_wait);
        return;
    }
    store(workspace - below::state, alternative::waiting);
    if (timer && load(workspace - below::timer_link) == alternative::time_set)
        join_timers(load(workspace - below::time));
    leave_processor();
    tell(workspace, timer ? ProcessChange::waits_for_time : ProcessChange::waits_in_alt);
}

// Clocks

Word Core::clock_at(Time time, int priority) const {
    if (!clocks_run_)
        return clock_start_;
    return clock_start_ + static_cast<Word>((time - clocks_since_) / tick_of(priority));
}

void Core::start_clocks(Word value) {
    clock_start_ = value;
    clocks_since_ = local_time();
    clocks_run_ = true;
    pop();
    find_next_timer();
}

/// Returns the earliest time at which the clock of this priority is after `time`.
Time Core::when_after(Word time, int priority) const {
    if (!clocks_run_)
        return Time::max();
    const Word now = clock(priority);
    if (is_after(now, time))
        return local_time();
    const std::int64_t ticks = std::int64_t{time - now} + 1;
    const std::int64_t passed = (local_time() - clocks_since_) / tick_of(priority);
    return clocks_since_ + (passed + ticks) * tick_of(priority);
}

void Core::wait_for_time() {
    const Word time = registers_.a;
    if (is_after(clock(priority_), time)) {
        pop();
        return;
    }
    join_timers(time);
    leave_processor();
    tell(registers_.workspace, ProcessChange::waits_for_time);
}

/// Puts the running process into the timer queue of its priority, after processes with the same time.
void Core::join_timers(Word time) {
    const Word workspace = registers_.workspace;
    store(workspace - below::time, time);
    Word place = reserved::timer_heads + 4 * static_cast<Word>(priority_);
    for (Word next = load(place), left = longest_queue(); next != not_a_process; next = load(place)) {
        if (is_after(load(next - below::time), time))
            break;
        place = next - below::timer_link;
        if (left-- == 0)
            return fault(Stopped::by_bad_address, place);
    }
    store(workspace - below::timer_link, load(place));
    store(place, workspace);
    find_next_timer();
}

/// Removes the process from its timer queue, and stores the time in its workspace. Does nothing if the process is not
/// in this queue. REQUIRES: the timer has not woken the process.
void Core::leave_timers(Word workspace, int priority, Time now) {
    Word place = reserved::timer_heads + 4 * static_cast<Word>(priority);
    for (Word next = load(place), left = longest_queue(); next != not_a_process && left > 0;
         next = load(place), --left) {
        if (next == workspace) {
            store(place, load(workspace - below::timer_link));
            store(workspace - below::timer_link, alternative::time_set);
            store(workspace - below::time, clock_at(now, priority));
            find_next_timer();
            return;
        }
        place = next - below::timer_link;
    }
}

void Core::wake_timers(int priority) {
    const Word head = reserved::timer_heads + 4 * static_cast<Word>(priority);
    for (Word left = longest_queue(); stopped_ == Stopped::nothing; --left) {
        const Word workspace = load(head);
        if (left == 0)
            return fault(Stopped::by_bad_address, workspace);
        if (workspace == not_a_process || timers_disabled_[static_cast<std::size_t>(priority)] ||
            !is_after(clock(priority), load(workspace - below::time)))
            return;
        store(head, load(workspace - below::timer_link));
        store(workspace - below::timer_link, alternative::time_set);
        store(workspace - below::time, clock(priority));
        if (load(workspace - below::state) == alternative::waiting)
            store(workspace - below::state, alternative::ready);
        tell(workspace, ProcessChange::becomes_ready);
        enqueue(workspace | static_cast<Word>(priority));
    }
}

void Core::find_next_timer() {
    next_timer_ = Time::max();
    for (const int priority : {0, 1}) {
        const Word workspace = load(reserved::timer_heads + 4 * static_cast<Word>(priority));
        if (workspace == not_a_process || timers_disabled_[static_cast<std::size_t>(priority)])
            continue;
        if (const Time due = when_after(load(workspace - below::time), priority); due < next_timer_)
            next_timer_ = due;
    }
    find_due();
}

} // namespace placedpar::transputer
