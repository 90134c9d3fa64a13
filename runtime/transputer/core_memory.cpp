#include "runtime/transputer/core.hpp"
#include "runtime/transputer/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <tuple>
#include <utility>

namespace placedpar::transputer {

// Memory

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
        return fmt::format("the bytes at #{:08X} are not an instruction of a {}", at, traits_.name);
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
