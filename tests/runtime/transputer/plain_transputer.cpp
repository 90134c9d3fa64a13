#include "plain_transputer.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar::test {

PlainTransputer::PlainTransputer(const PlainSettings& given)
    : settings(given), memory(given.memory), iptr(mem_start()), wptr(mem_start() + 0x400) {}

void PlainTransputer::stop(std::string_view reason) const { throw Stop{std::string(reason)}; }

void PlainTransputer::push(Word value) {
    c = b;
    b = a;
    a = value;
    undefined = undefined << 1 & 7;
}

PlainTransputer::Word PlainTransputer::pop() {
    const Word value = a;
    a = b;
    b = c;
    undefined = undefined >> 1 | (undefined & 4);
    return value;
}

void PlainTransputer::binary(Word value) {
    const bool unknown = undefined & 3;
    pop();
    a = value;
    undefined = (undefined & 6) | unknown;
}

void PlainTransputer::pop_all(unsigned count) {
    for (unsigned i = 0; i < count; ++i)
        pop();
}

// Memory.

std::size_t PlainTransputer::offset(Word address, bool wraps) {
    Word place = address - most_neg;
    if (place >= memory.size()) {
        if (!wraps)
            stop(fmt::format("access outside memory: #{:08X}", address));
        place %= static_cast<Word>(memory.size());
    }
    if (place >= on_chip() && !pending_.operation)
        extra += 2 * (settings.memorycycles - 1);
    return place;
}

std::uint8_t PlainTransputer::load_byte(Word address, bool wraps) { return memory[offset(address, wraps)]; }

void PlainTransputer::store_byte(Word address, std::uint8_t value, bool wraps) {
    memory[offset(address, wraps)] = value;
}

PlainTransputer::Word PlainTransputer::load(Word address, bool wraps) {
    return peek(most_neg + static_cast<Word>(offset(address & ~3U, wraps)));
}

void PlainTransputer::store(Word address, Word value, bool wraps) {
    poke(most_neg + static_cast<Word>(offset(address & ~3U, wraps)), value);
}

PlainTransputer::Word PlainTransputer::peek(Word address) const {
    Word value = 0;
    for (Word i = 4; i-- > 0;)
        value = value << 8 | memory.at(address - most_neg + i);
    return value;
}

void PlainTransputer::poke(Word address, Word value) {
    for (Word i = 0; i < 4; ++i)
        memory.at(address - most_neg + i) = static_cast<std::uint8_t>(value >> 8 * i);
}

void PlainTransputer::poke(Word address, std::span<const std::uint8_t> bytes) {
    for (const auto byte : bytes)
        memory.at(address++ - most_neg) = byte;
}

void PlainTransputer::copy(Word target, Word source, Word count) {
    for (const Word first : {source, target})
        if (count != 0 && std::uint64_t{first - most_neg} + count > memory.size())
            stop(fmt::format("copy outside memory: {} bytes at #{:08X}", count, first));
    for (Word i = 0; i < count; ++i)
        memory[target - most_neg + i] = memory[source - most_neg + i];
}

void PlainTransputer::pay_for_copy(Word first, Word second, Word count) {
    const auto words = [&](Word address) { return count == 0 ? 0 : ((address & 3) + std::uint64_t{count} + 3) / 4; };
    cycles += 2 * words(first);
    for (const Word address : {first, second})
        if (address - most_neg >= on_chip())
            extra += 2 * (settings.memorycycles - 1) * words(address);
}

// Instructions.

std::uint64_t PlainTransputer::step() {
    const auto began = now;
    if (!stopped.empty())
        return 0;
    begun_at = iptr;
    try {
        if (idle)
            wait_for_timer();
        else if (pending_.operation)
            go_on_with_pending();
        else
            execute();
    } catch (const Stop& why) {
        stopped = fmt::format("{} at #{:08X}", why.reason, begun_at);
    }
    return now - began;
}

std::uint64_t PlainTransputer::run(Word until, int steps) {
    const auto began = now;
    while (stopped.empty() && steps-- > 0 && (idle || iptr != until))
        step();
    return now - began;
}

void PlainTransputer::execute() {
    const auto fetch = [this] {
        const auto before = extra;
        const auto byte = load_byte(iptr);
        extra = before + (fetched == iptr / 4 ? 0 : (extra - before) / 2);
        fetched = iptr++ / 4;
        return byte;
    };
    operand = 0;
    cycles = extra = 0;
    leaving = may_slice = has_erred = false;
    slice_is_over = priority == 1 && front[1] != not_process && slice() - slice_began >= 2;
    for (;;) {
        const unsigned byte = fetch();
        operand |= byte & 15;
        if (byte >> 4 != 2 && byte >> 4 != 6) {
            direct(byte >> 4);
            break;
        }
        operand = (byte >> 4 == 2 ? operand : ~operand) << 4;
        cycles += 1;
    }
    now += 2 * cycles + extra;
    if (halt_on_error && has_erred)
        stop("halted on error");
    if (pending_.operation) {
        cycles = pending_.operation->cycles;
        extra = 0;
        pending_.operation->cost(*this);
        pending_.left = 2 * cycles + extra;
        go_on_with_pending();
    } else {
        finish();
    }
}

void PlainTransputer::direct(unsigned function) {
    const Word o = operand;
    switch (function) {
    case 0x0: // j
        if (j0_break && o == 0) {
            execute_from(plain_integer_operations, 0xB1); // takes as long as `break`
            break;
        }
        cycles += 3;
        iptr += o;
        may_slice = true;
        break;
    case 0x1: cycles += 1, push(wptr + 4 * o); break;        // ldlp
    case 0x3: cycles += 2, a = load(a + 4 * o, true); break; // ldnl
    case 0x4: cycles += 1, push(o); break;                   // ldc
    case 0x5: cycles += 1, a += 4 * o; break;                // ldnlp
    case 0x7: cycles += 2, push(load(wptr + 4 * o)); break;  // ldl
    case 0x8: {                                              // adc
        cycles += 1;
        const Word sum = a + o;
        if (((a ^ sum) & (o ^ sum)) >> 31)
            set_error();
        a = sum;
        break;
    }
    case 0x9: // call
        cycles += 7;
        store_local(-1, c);
        store_local(-2, b);
        store_local(-3, a);
        store_local(-4, iptr);
        wptr -= 16;
        a = iptr;
        iptr += o;
        break;
    case 0xA: // cj
        cycles += a == 0 ? 4 : 2;
        if (a == 0)
            iptr += o;
        else
            pop();
        break;
    case 0xB: cycles += 1, wptr += 4 * o; break;              // ajw
    case 0xC: cycles += 2, a = a == o; break;                 // eqc
    case 0xD: cycles += 1, store(wptr + 4 * o, pop()); break; // stl
    case 0xE:                                                 // stnl
        cycles += 2;
        store(a + 4 * o, b, true);
        pop_all(2);
        break;
    default: // opr: bits of the code above the tenth are ignored
        if (!execute_from(plain_integer_operations, o & 0x3FF) &&
            !execute_from(plain_scheduling_operations, o & 0x3FF) && !execute_floating_point(o & 0x3FF))
            stop(fmt::format("unknown operation #{:X}", o & 0x3FF));
    }
}

bool PlainTransputer::execute_from(std::span<const PlainOperation> table, unsigned code) {
    for (const auto& row : table) {
        if (row.code != code || !(row.models & settings.model))
            continue;
        if (row.when == When::at_once) {
            cycles += row.cycles;
            row.effect(*this);
        } else {
            pending_.operation = &row;
        }
        return true;
    }
    return false;
}

} // namespace placedpar::test
