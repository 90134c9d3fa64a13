#pragma once

#include "runtime/transputer/core.hpp"
#include "runtime/transputer/words.hpp"

#include <cstddef>
#include <cstring>

/// Communication between processes of one transputer, and the switch to the next process. These functions of Core are
/// inline, because the loop that executes instructions calls them often.
namespace placedpar::transputer {

#define PLACEDPAR_EXPANDED [[gnu::always_inline]] inline

// Processes

/// Stores the address at which a process that leaves the processor will continue.
PLACEDPAR_EXPANDED void Core::store_instruction(const Registers& r) {
    store(r.workspace - below::instruction, r.instruction);
}

PLACEDPAR_EXPANDED void Core::enqueue(Word process) {
    const Word workspace = process & ~Word{3};
    const std::size_t priority = process & 1;
    if (front_[priority] == not_a_process)
        front_[priority] = workspace;
    else
        store(back_[priority] - below::link, workspace);
    back_[priority] = workspace;
}

/// Takes the process at the front of a queue. REQUIRES: the queue is not empty.
PLACEDPAR_EXPANDED void Core::take_front(std::size_t priority, Registers& r) {
    if (shuffle_) [[unlikely]]
        put_off_some(priority);
    r.workspace = front_[priority];
    front_[priority] = r.workspace == back_[priority] ? not_a_process : load(r.workspace - below::link);
    r.instruction = load(r.workspace - below::instruction);
    local_ += switch_;
    slices_seen_ = 0;
}

// Channels

PLACEDPAR_EXPANDED bool Core::Communication::meets_alternative() const {
    return partner_pointer == alternative::enabling || partner_pointer == alternative::waiting ||
           partner_pointer == alternative::ready;
}

/// Returns the communication of an instruction: in, out, outbyte or outword.
PLACEDPAR_EXPANDED Core::Communication Core::communication_by(Operation operation, const Registers& r) {
    Communication result{.channel = r.b, .address = r.c, .bytes = r.a};
    if (operation == Operation::outbyte || operation == Operation::outword) {
        result.address = r.workspace;
        result.bytes = operation == Operation::outword ? 4 : 1;
    }
    if (hard_channel(r.b) < 0)
        result.partner = load(r.b);
    if (result.partner != not_a_process)
        result.partner_pointer = load((result.partner & ~Word{3}) - below::pointer);
    return result;
}

PLACEDPAR_EXPANDED HalfCycles Core::cost_of(Operation operation, const Communication& asked) const {
    const bool copies = asked.meets_process();
    if (operation == Operation::outbyte || operation == Operation::outword)
        return 2 * (copies || hard_channel(asked.channel) >= 0 ? 23 : 21);
    const HalfCycles waits = 2 * 19;
    if (!copies)
        return waits;
    return waits + 4 * words_touched(asked.address, asked.bytes) + outside_words(asked.address, asked.bytes) +
           outside_words(asked.partner_pointer, asked.bytes);
}

PLACEDPAR_EXPANDED void Core::copy_message(Word from, Word to, Word bytes) {
    const Word source = NodeMemory::offset_of(from), target = NodeMemory::offset_of(to);
    if (bytes != 4 || (target & 3) != 0 || source > memory_.size() - 4 || target >= memory_.size() ||
        memory_.must_prepare(target))
        return move_block(from, to, bytes);
    std::memcpy(memory_.data() + target, memory_.data() + source, 4);
}

/// Performs an input or output at a channel in memory. Returns whether the process can continue.
PLACEDPAR_EXPANDED bool Core::communicate(bool is_output, const Communication& asked, const Registers& r) {
    if (asked.meets_process() || (!is_output && asked.partner != not_a_process)) {
        copy_message(is_output ? asked.address : asked.partner_pointer,
                     is_output ? asked.partner_pointer : asked.address, asked.bytes);
        store(asked.channel, not_a_process);
        enqueue(asked.partner);
        return true;
    }
    if (asked.partner != not_a_process)
        wake_alternative(asked.partner, local_time(), ProcessChange::communicated);
    store(asked.channel, descriptor(r));
    store(r.workspace - below::pointer, asked.address);
    store_instruction(r);
    return false;
}

/// Performs the communication and, if needed, switches to the next process. Does nothing and returns `scheduling` if
/// the channel belongs to a link, or if the communication and a switch to another process would not end before `until`.
/// Returns `budget` if execution can continue.
PLACEDPAR_EXPANDED Core::Left Core::communicate_at_once(Operation operation, Registers& r, HalfCycles until) {
    const Communication asked = communication_by(operation, r);
    const HalfCycles ends = local_ + cost_of(operation, asked);
    if (hard_channel(asked.channel) >= 0 || ends + switch_ >= until || stopped_ != Stopped::nothing)
        return Left::scheduling;
    local_ = ends;
    if (operation == Operation::outbyte || operation == Operation::outword)
        store(r.workspace, r.a);
    return switch_at_once(communicate(operation != Operation::in, asked, r), r);
}

/// Takes the next process from its queue if the running process does not continue. Returns `performed` if only the
/// scheduler can choose the next process.
PLACEDPAR_EXPANDED Core::Left Core::switch_at_once(bool goes_on, Registers& r) {
    if (stopped_ != Stopped::nothing)
        return Left::performed;
    const auto priority = static_cast<std::size_t>(priority_);
    const bool is_interrupted = priority == 1 && front_[0] != not_a_process;
    running_ = goes_on;
    if (is_interrupted || (!goes_on && front_[priority] == not_a_process))
        return Left::performed;
    if (!goes_on)
        take_front(priority, r);
    running_ = true;
    return stopped_ == Stopped::nothing ? Left::budget : Left::performed;
}

} // namespace placedpar::transputer
