#include "runtime/transputer/communication.hpp"
#include "runtime/transputer/single_length.hpp"
#include "runtime/transputer/words.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <tuple>
#include <utility>

// This file has the loop that executes instructions. Each instruction jumps to the next instruction through the address
// of a label (computed goto), an extension of GCC and Clang.
#pragma GCC diagnostic ignored "-Wpedantic"

// Without this option, GCC would merge common parts of instructions, and would then run out of the host's registers.
#if defined(__GNUC__) && !defined(__clang__)
#define PLACEDPAR_KEEPS_REGISTERS [[gnu::optimize("no-tree-pre", "no-gcse")]]
#else
#define PLACEDPAR_KEEPS_REGISTERS
#endif

namespace placedpar::transputer {

// These are the macros that the effects in instructions.inc use. `spent` counts half cycles: those of the blocks before
// this block, and those that effects have added in this block.

#define OPERAND (entry->operand)
#define NEXT_ADDRESS (entry->operand)
#define CALL_RETURNS_TO (entry[1].operand)
#define PRIORITY (static_cast<Word>(priority_))
#define ERROR_FLAG (registers_.error)
#define DOUBLE (fpu_.fa().length == Length::real64)

#define NEXT()                                                                                                         \
    do {                                                                                                               \
        ++entry;                                                                                                       \
        goto* labels[static_cast<std::size_t>(entry->operation)];                                                      \
    } while (false)
#define BRANCH(address)                                                                                                \
    do {                                                                                                               \
        next = (address);                                                                                              \
        goto branch;                                                                                                   \
    } while (false)
#define BRANCH_OR_GIVE_WAY(address)                                                                                    \
    do {                                                                                                               \
        next = (address);                                                                                              \
        goto branch_or_give_way;                                                                                       \
    } while (false)
#define SPEND(cycles) (spent += 2 * static_cast<HalfCycles>(cycles))
#define PUSH(value_)                                                                                                   \
    do {                                                                                                               \
        const Word pushed = static_cast<Word>(value_);                                                                 \
        C = B;                                                                                                         \
        B = A;                                                                                                         \
        A = pushed;                                                                                                    \
    } while (false)
#define POP() (A = B, B = C)
// An instruction that sets Error still has its effect.
#define CHECK(error_, effect)                                                                                          \
    do {                                                                                                               \
        if (error_) [[unlikely]] {                                                                                     \
            note_error(*block, *entry, {0, W, A, B, C});                                                               \
            effect;                                                                                                    \
            if (halts_on_error_)                                                                                       \
                goto halt;                                                                                             \
        } else {                                                                                                       \
            effect;                                                                                                    \
        }                                                                                                              \
    } while (false)

#define REACH(address, bytes, always_wraps)                                                                            \
    Word offset = NodeMemory::offset_of(address);                                                                      \
    if ((bytes) > 1)                                                                                                   \
        offset &= ~Word{3};                                                                                            \
    if (offset > size - (bytes)) [[unlikely]] {                                                                        \
        bad = (address);                                                                                               \
        if (!(always_wraps) && !timing_.wraps)                                                                         \
            goto bad_address;                                                                                          \
        offset = memory_.wrapped(offset);                                                                              \
    }                                                                                                                  \
    spent += offset >= on_chip ? penalty : 0
#define BEFORE_WRITE(bytes)                                                                                            \
    if (page_flags[offset / NodeMemory::page_bytes]) [[unlikely]]                                                      \
    page_is_written(*block, *entry, offset, bytes)
#define LOAD_BY(address, variable, always_wraps)                                                                       \
    do {                                                                                                               \
        REACH(address, 4, always_wraps);                                                                               \
        std::memcpy(&variable, memory + offset, 4);                                                                    \
    } while (false)
#define STORE_BY(address, value_, always_wraps)                                                                        \
    do {                                                                                                               \
        const Word stored = static_cast<Word>(value_);                                                                 \
        REACH(address, 4, always_wraps);                                                                               \
        BEFORE_WRITE(4);                                                                                               \
        std::memcpy(memory + offset, &stored, 4);                                                                      \
    } while (false)
#define LOAD(address, variable) LOAD_BY(address, variable, false)
#define LOAD_WRAPPED(address, variable) LOAD_BY(address, variable, true)
#define STORE(address, value_) STORE_BY(address, value_, false)
#define STORE_WRAPPED(address, value_) STORE_BY(address, value_, true)
#define LOAD_BYTE(address, variable)                                                                                   \
    do {                                                                                                               \
        REACH(address, 1, true);                                                                                       \
        variable = memory[offset];                                                                                     \
    } while (false)
#define STORE_BYTE(address, value_)                                                                                    \
    do {                                                                                                               \
        REACH(address, 1, true);                                                                                       \
        BEFORE_WRITE(1);                                                                                               \
        memory[offset] = static_cast<std::uint8_t>(value_);                                                            \
    } while (false)
#define LOAD_DOUBLE(address, variable)                                                                                 \
    do {                                                                                                               \
        Word low, high;                                                                                                \
        LOAD(address, low);                                                                                            \
        LOAD((address) + 4, high);                                                                                     \
        variable = std::uint64_t{high} << 32 | low;                                                                    \
    } while (false)
#define STORE_DOUBLE(address, value_)                                                                                  \
    do {                                                                                                               \
        const std::uint64_t stored_both = (value_);                                                                    \
        STORE(address, stored_both);                                                                                   \
        STORE((address) + 4, stored_both >> 32);                                                                       \
    } while (false)

// These macros are for instructions of the floating-point unit. The integer unit passes such an instruction on, and
// continues after one cycle. At the next floating-point instruction it waits until the floating-point unit is free. At
// a RESULT it also waits for the result.
#define AWAIT_REALS(own_cycles)                                                                                        \
    const HalfCycles begins = local_ + spent + entry->after - 2;                                                       \
    if (fpu_free_ > begins)                                                                                            \
        spent += fpu_free_ - begins;                                                                                   \
    fpu_free_ = std::max(fpu_free_, begins) + 2 * static_cast<HalfCycles>(own_cycles)
#define SET_REGISTERS(...)                                                                                             \
    do {                                                                                                               \
        const SingleLengthRegisters result = __VA_ARGS__;                                                              \
        A = result.a;                                                                                                  \
        B = result.b;                                                                                                  \
        C = result.c;                                                                                                  \
    } while (false)
#define ENTER(selector)                                                                                                \
    do {                                                                                                               \
        const Operation entered = selected_by(selector);                                                               \
        if (entered == Operation::unknown) {                                                                           \
            bad = (selector);                                                                                          \
            goto unknown_selector;                                                                                     \
        }                                                                                                              \
        goto* labels[static_cast<std::size_t>(entered)];                                                               \
    } while (false)

// This macro is for instructions of the scheduler. `function` performs the instruction now if nothing can act on the
// core before the instruction ends.
#define AT_ONCE(function, operation_)                                                                                  \
    {                                                                                                                  \
        Registers r{entry->operand, W, A, B, C, registers_.error};                                                     \
        local_ += std::exchange(spent, 0) + entry->after;                                                              \
        begun_ = operation_;                                                                                           \
        left = function(operation_, r, until_at_once);                                                                 \
        A = r.a, B = r.b, C = r.c, W = r.workspace, next = r.instruction;                                              \
        if (left != Left::budget)                                                                                      \
            goto leave;                                                                                                \
        slice_is_over = slices_seen_ >= 2 && is_slice_over();                                                          \
        budget = until - local_;                                                                                       \
        goto begin_block;                                                                                              \
    }

PLACEDPAR_KEEPS_REGISTERS
Core::Left Core::execute(HalfCycles until, bool at_once) {
    static const void* const labels[] = {
#define FUNCTION(code, name, cycles, extra, accesses, ...) &&at_##name,
#define OPERATION(code, name, cycles, extra, accesses, models, ...) &&at_##name,
#define REAL(code, name, cycles, accesses, ...) &&at_##name,
#define RESULT(code, name, cycles, accesses, ...) &&at_##name,
#define SELECTED(code, name, cycles, ...) &&at_##name,
#define SCHEDULING(code, name, cycles, models) &&scheduling,
#define COMMUNICATING(code, name, cycles, models) &&at_##name,
#include "runtime/transputer/instructions.inc"
        &&go_on,
        &&j_zero,
        &&unknown,
#define FUNCTION(code, name, ...)                                                                                      \
    &&at_##name##_ldl, &&at_##name##_ldc, &&at_##name##_ldlp, &&at_##name##_stl, &&at_##name##_adc,
#include "runtime/transputer/instructions.inc"
    };

    std::uint8_t* const memory = memory_.data();
    const std::uint8_t* const page_flags = memory_.page_flags();
    const Word size = memory_.size(), on_chip = traits_.bytes_on_chip;
    const HalfCycles penalty = penalty_;
    bool slice_is_over = is_slice_over();
    Word A = registers_.a, B = registers_.b, C = registers_.c, W = registers_.workspace;
    Word next = registers_.instruction, value = 0, bad = 0, last_fetched = last_fetched_;
    std::uint64_t wide = 0;
    HalfCycles budget = until - local_, spent = 0;
    const HalfCycles until_at_once = at_once ? until : 0;
    Left left = Left::budget;
    Block* block = nullptr;
    const Entry* entry = nullptr;

begin_block:
    if (spent >= budget)
        goto leave;
    block = code_.at(next);
    if (!block && timing_.wraps)
        block = code_.at_wrapped(next);
    if (!block) {
        left = Left::bad_address;
        stopped_at_ = next;
        goto leave;
    }
    if (spent + block->most > budget)
        block = code_.front_of(*block, budget - spent);
    if (block->first_word != last_fetched)
        spent += block->first_fetch;
    last_fetched = block->last_word;
    instructions_ += block->instructions;
    entry = block->entries.get();
    goto* labels[static_cast<std::size_t>(entry->operation)];

#define FUNCTION(code, name, cycles, extra, accesses, ...)                                                             \
    at_##name : __VA_ARGS__;                                                                                           \
    NEXT();
#define OPERATION(code, name, cycles, extra, accesses, models, ...)                                                    \
    at_##name : __VA_ARGS__;                                                                                           \
    NEXT();
#define REAL(code, name, cycles, accesses, ...)                                                                        \
    at_##name : { AWAIT_REALS(cycles); }                                                                               \
    __VA_ARGS__;                                                                                                       \
    NEXT();
#define RESULT(code, name, cycles, accesses, ...)                                                                      \
    at_##name : {                                                                                                      \
        AWAIT_REALS(cycles);                                                                                           \
        spent += 2 * ((cycles)-1);                                                                                     \
    }                                                                                                                  \
    __VA_ARGS__;                                                                                                       \
    NEXT();
#define SELECTED(code, name, cycles, ...)                                                                              \
    at_##name : { AWAIT_REALS(cycles); }                                                                               \
    __VA_ARGS__;                                                                                                       \
    NEXT();
#define COMMUNICATING(code, name, cycles, models) at_##name : AT_ONCE(communicate_at_once, Operation::name)
#include "runtime/transputer/instructions.inc"

// Pairs of direct functions
#define FUNCTION(code, name, cycles, extra, accesses, ...)                                                             \
    PAIR(name, ldl, __VA_ARGS__)                                                                                       \
    PAIR(name, ldc, __VA_ARGS__)                                                                                       \
    PAIR(name, ldlp, __VA_ARGS__)                                                                                      \
    PAIR(name, stl, __VA_ARGS__)                                                                                       \
    PAIR(name, adc, __VA_ARGS__)
#define PAIR(name, second, ...)                                                                                        \
    at_##name##_##second : __VA_ARGS__;                                                                                \
    ++entry;                                                                                                           \
    goto at_##second;
#include "runtime/transputer/instructions.inc"
#undef PAIR

branch:
    spent += entry->after;
    if (code_.must_sweep())
        code_.sweep();
    goto begin_block;
branch_or_give_way:
    spent += entry->after;
    if (!slice_is_over)
        goto begin_block;
    left = Left::timeslice;
    goto leave;
go_on:
    next = entry->operand;
    last_fetched = (NodeMemory::offset_of(next) - 1) & ~Word{3}; // a block that was written to may end early
    goto branch;
j_zero:
    if (!breaks_at_j0_)
        BRANCH_OR_GIVE_WAY(OPERAND);
    next = entry->operand;
    spent += entry->after - 2 * description_of(Operation::j).cycles; // our choice: this instruction takes as long as
                                                                     // `break`
    begun_ = Operation::break_;
    left = Left::scheduling;
    goto leave;
scheduling:
    AT_ONCE(perform_at_once, entry->operation)
halt:
    next = place_of(*block, *entry) + entry->length;
    spent += entry->after;
    instructions_ -= instructions_after(*block, *entry);
    left = Left::halt;
    goto leave;
unknown:
    next = place_of(*block, *entry);
    spent += entry->after;
    stopped_at_ = 0;
    left = Left::unknown;
    goto leave;
unknown_selector:
    next = place_of(*block, *entry);
    spent += entry->after;
    instructions_ -= instructions_after(*block, *entry);
    left = Left::unknown_selector;
    stopped_at_ = bad;
    goto leave;
bad_address:
    next = place_of(*block, *entry);
    spent += entry->after;
    instructions_ -= instructions_after(*block, *entry);
    left = Left::bad_address;
    stopped_at_ = bad;
leave:
    registers_.a = A;
    registers_.b = B;
    registers_.c = C;
    registers_.workspace = W;
    registers_.instruction = next;
    last_fetched_ = last_fetched;
    local_ += spent;
    return left;
}

std::uint64_t Core::instructions_after(const Block& block, const Entry& entry) {
    return block.instructions - static_cast<std::uint64_t>(&entry - block.entries.get()) - 1;
}

/// Sets Error. Notes the registers as they were before the instruction, if Error was clear.
[[gnu::cold, gnu::noinline]] void Core::note_error(const Block& block, const Entry& entry, ErrorNote found) {
    if (std::exchange(registers_.error, true))
        return;
    found.after = place_of(block, entry) + entry.length;
    noted_[static_cast<std::size_t>(priority_)] = found;
}

Word Core::place_of(const Block& block, const Entry& entry) const {
    Word result = block.start;
    for (const Entry* each = block.entries.get(); each != &entry; ++each)
        result += each->length;
    return result;
}

void Core::page_is_written(Block& block, const Entry& entry, Word offset, Word bytes) {
    memory_.save(offset, bytes);
    if (!memory_.has_code(offset, bytes))
        return;
    code_.forget(offset, bytes);
    const Word begin = NodeMemory::offset_of(block.start);
    if (offset + bytes <= begin || offset >= begin + block.bytes)
        return;
    // The instruction has written to its own page, so the rest of this block may have changed. The block now ends after
    // this instruction.
    instructions_ -= instructions_after(block, entry);
    Entry& rest = const_cast<Entry&>((&entry)[1]);
    rest = {Operation::go_on, 0, entry.after, place_of(block, entry) + entry.length};
}

} // namespace placedpar::transputer

#undef OPERAND
#undef NEXT_ADDRESS
#undef CALL_RETURNS_TO
#undef PRIORITY
#undef ERROR_FLAG
#undef DOUBLE
#undef NEXT
#undef BRANCH
#undef BRANCH_OR_GIVE_WAY
#undef SPEND
#undef PUSH
#undef POP
#undef CHECK
#undef REACH
#undef BEFORE_WRITE
#undef LOAD_BY
#undef STORE_BY
#undef LOAD
#undef LOAD_WRAPPED
#undef STORE
#undef STORE_WRAPPED
#undef LOAD_BYTE
#undef STORE_BYTE
#undef LOAD_DOUBLE
#undef STORE_DOUBLE
#undef AWAIT_REALS
#undef SET_REGISTERS
#undef ENTER
#undef AT_ONCE
