#include "runtime/transputer/code_lines.hpp"
#include "runtime/transputer/communication.hpp"
#include "runtime/transputer/words.hpp"

#include <cstddef>
#include <utility>

namespace placedpar::transputer {

// Channels

void Core::transfer_ended(int channel) {
    const Word address = most_negative + 4 * static_cast<Word>(channel);
    const Word process = load(address);
    store(address, not_a_process);
    if (process == not_a_process)
        return;
    tell(process, ProcessChange::becomes_ready, address);
    enqueue(process);
}

void Core::begin_communication(Operation operation) {
    if (operation == Operation::outbyte || operation == Operation::outword)
        store(registers_.workspace, registers_.a);
    const Communication asked = communication_by(operation, registers_);
    if (const int link = hard_channel(asked.channel); link >= 0)
        return communicate_by_link(link, asked);
    running_ = communicate(operation != Operation::in, asked, registers_) && stopped_ == Stopped::nothing;
    if (running_)
        tell(asked.partner, ProcessChange::communicated, asked.channel);
    else if (stopped_ == Stopped::nothing)
        tell(registers_.workspace,
             operation == Operation::in ? ProcessChange::waits_for_input : ProcessChange::waits_for_output,
             asked.channel);
}

void Core::communicate_by_link(int link, const Communication& asked) {
    if (asked.bytes == 0 && link < static_cast<int>(hard_channels) - 1)
        return;
    if (!memory_.holds(NodeMemory::offset_of(asked.address), asked.bytes) && !can_wrap(asked.bytes))
        return fault(Stopped::by_bad_address, asked.address);
    store(asked.channel, descriptor());
    leave_processor();
    tell(registers_.workspace, link < 4 ? ProcessChange::waits_for_output : ProcessChange::waits_for_input,
         asked.channel);
    links_.begin_transfer(link, asked.address, asked.bytes);
}

/// Notes in the state of an ALT that one of its channels is ready, and makes the process ready if it waits. `woken`:
/// the change to report to a watcher, which differs for channels of links.
void Core::wake_alternative(Word partner, Time now, ProcessChange woken) {
    const Word workspace = partner & ~Word{3};
    const Word state = load(workspace - below::state);
    store(workspace - below::state, alternative::ready);
    if (state != alternative::waiting)
        return;
    leave_timers(workspace, static_cast<int>(partner & 1), now);
    tell(workspace, woken);
    enqueue(partner);
}

void Core::byte_has_come(int channel, Time now) {
    if (const Word waiting = load(most_negative + 4 * static_cast<Word>(channel)); waiting != not_a_process)
        wake_alternative(waiting, now, ProcessChange::becomes_ready);
}

void Core::reset_channel() {
    const Word channel = registers_.a;
    registers_.a = load(channel);
    store(channel, not_a_process);
    if (const int hard = hard_channel(channel); hard >= 0)
        links_.reset(hard);
}

// Instructions of the scheduler

HalfCycles Core::cost_of(Operation operation) {
    const Registers& r = registers_;
    const HalfCycles cycles = 2 * static_cast<HalfCycles>(cycles_of(operation, model_));
    switch (operation) {
    case Operation::in:
    case Operation::out:
    case Operation::outbyte:
    case Operation::outword: return cost_of(operation, communication_by(operation, registers_));
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
    case Operation::in:
    case Operation::out:
    case Operation::outbyte:
    case Operation::outword: begin_communication(operation); break;
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
    case Operation::break_: fault(Stopped::by_break, r.instruction); break;
    case Operation::move: move_block(r.c, r.b, r.a); break;
    case Operation::move2dall:
    case Operation::move2dnonzero:
    case Operation::move2dzero: move_in_two_dimensions(operation); break;
    default: perform_on_processes(operation); break;
    }
}

void Core::perform_on_processes(Operation operation) {
    Registers& r = registers_;
    switch (operation) {
    case Operation::startp:
        store(r.a - below::instruction, r.instruction + r.b);
        tell(r.a, ProcessChange::becomes_ready);
        enqueue((r.a & ~Word{3}) | static_cast<Word>(priority_));
        r.a = r.b = r.c;
        break;
    case Operation::endp: end_process(); break;
    case Operation::runp:
        tell(r.a, ProcessChange::becomes_ready);
        enqueue(r.a);
        pop();
        break;
    case Operation::stopp:
        if (lines_ && !lines_->error(r.instruction).empty())
            stop_by_error({r.instruction, r.workspace, r.a, r.b, r.c});
        else
            stop_process();
        break;
    case Operation::stoperr:
        if (r.error)
            stop_by_error(noted_[static_cast<std::size_t>(priority_)]);
        break;
    case Operation::go_on: give_way(); break;
    default: perform_on_queues(operation); break;
    }
}

/// Stores or sets queue registers, and enables or disables timers.
void Core::perform_on_queues(Operation operation) {
    const auto set = [this](Word& queue) {
        queue = registers_.a;
        pop();
    };
    const auto save = [this](std::size_t queue) {
        store(registers_.a, front_[queue]);
        store(registers_.a + 4, back_[queue]);
        pop();
    };
    switch (operation) {
    case Operation::saveh: return save(0);
    case Operation::savel: return save(1);
    case Operation::sthf: return set(front_[0]);
    case Operation::sthb: return set(back_[0]);
    case Operation::stlf: return set(front_[1]);
    case Operation::stlb: return set(back_[1]);
    case Operation::timerdisableh: timers_disabled_[0] = true; break;
    case Operation::timerdisablel: timers_disabled_[1] = true; break;
    case Operation::timerenableh: timers_disabled_[0] = false; break;
    case Operation::timerenablel: timers_disabled_[1] = false; break;
    default: break;
    }
    find_next_timer();
}

} // namespace placedpar::transputer
