#include "runtime/transputer/core.hpp"
#include "runtime/transputer/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <tuple>
#include <utility>
#include <vector>

namespace placedpar::transputer {

// Memory

/// Returns whether a program may use an interval of addresses. If the interval is not in the memory and addresses wrap
/// round, replaces `offset` by the offset to which it wraps.
bool Core::reaches(Word& offset, Word bytes) const {
    if (memory_.holds(offset, bytes))
        return true;
    if (timing_.wraps)
        offset = memory_.wrapped(offset);
    return timing_.wraps;
}

Word Core::load_outside(Word address) {
    if (timing_.wraps)
        return memory_.word(memory_.wrapped(NodeMemory::offset_of(address) & ~Word{3}));
    fault(Stopped::by_bad_address, address);
    return not_a_process;
}

void Core::store_outside(Word address, Word value) {
    if (timing_.wraps)
        write(memory_.wrapped(NodeMemory::offset_of(address) & ~Word{3}),
              {reinterpret_cast<const std::uint8_t*>(&value), 4});
    else
        fault(Stopped::by_bad_address, address);
}

void Core::write(Word offset, std::span<const std::uint8_t> bytes) {
    if (bytes.empty())
        return;
    const auto count = static_cast<Word>(bytes.size());
    if (memory_.must_prepare(offset, count))
        prepare_write(offset, count);
    std::memmove(memory_.data() + offset, bytes.data(), bytes.size());
}

void Core::prepare_write(Word offset, Word bytes) {
    memory_.save(offset, bytes);
    if (memory_.has_code(offset, bytes))
        code_.forget(offset, bytes);
}

void Core::keep() {
    kept_ = *this;
    memory_.keep();
}

void Core::go_back() {
    static_cast<CoreState&>(*this) = kept_;
    memory_.go_back([this](Word offset, Word bytes) {
        if (memory_.has_code(offset, bytes))
            code_.forget(offset, bytes);
    });
}

void Core::copy_from_memory(Word offset, std::span<std::uint8_t> to) {
    const auto bytes = static_cast<Word>(to.size());
    if (memory_.holds(offset, bytes))
        std::ranges::copy(memory_.bytes(offset, bytes), to.begin());
    else if (timing_.wraps)
        for (std::uint8_t& each : to)
            each = memory_.byte(memory_.wrapped_or_not(offset++));
    else
        fault(Stopped::by_bad_address, most_negative + offset);
}

void Core::copy_to_memory(Word offset, std::span<const std::uint8_t> bytes) {
    if (memory_.holds(offset, static_cast<Word>(bytes.size())))
        write(offset, bytes);
    else if (timing_.wraps)
        for (const std::uint8_t& each : bytes)
            write(memory_.wrapped_or_not(offset++), {&each, 1});
    else
        fault(Stopped::by_bad_address, most_negative + offset);
}

void Core::move_block(Word from, Word to, Word bytes) {
    const Word source = NodeMemory::offset_of(from), target = NodeMemory::offset_of(to);
    if (bytes == 0) // some programs move 0 bytes from or to address 0
        return;
    if (memory_.holds(source, bytes) && memory_.holds(target, bytes))
        return write(target, memory_.bytes(source, bytes));
    if (!can_wrap(bytes))
        return fault(Stopped::by_bad_address, memory_.holds(source, bytes) ? to : from);
    std::vector<std::uint8_t> copied(bytes);
    copy_from_memory(source, copied);
    copy_to_memory(target, copied);
}

/// Returns whether an interval of this length may extend beyond the memory. Addresses must wrap round, and the interval
/// must not contain a byte of the memory twice.
bool Core::can_wrap(Word bytes) const { return timing_.wraps && bytes <= memory_.size(); }

/// Moves rows of bytes: all bytes, only the bytes that are not 0, or only the bytes that are 0.
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
            Word offset = NodeMemory::offset_of(from + i);
            const bool is_zero = reaches(offset, 1) && memory_.byte(offset) == 0;
            if (is_zero == (operation == Operation::move2dzero))
                move_block(from + i, to + i, 1);
        }
    }
}

// Errors

void Core::fault(Stopped why, Word address) {
    if (stopped_ != Stopped::nothing)
        return;
    if (running_)
        tell(registers_.workspace, ProcessChange::stops);
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
        return fmt::format("the bytes at #{:08X} are not an instruction of a {}", at, traits_.name);
    case Stopped::by_bad_address:
        return fmt::format(
            "the instruction at #{:08X} uses the address #{:08X}, but memory is from #80000000 to #{:08X}", at,
            stopped_at_, most_negative + memory_.size() - 1);
    case Stopped::by_analyse:
        return fmt::format("the analyse pin stopped the processor before the instruction at #{:08X}", at);
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
