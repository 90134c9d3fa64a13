#include "runtime/hardware/bus_memory.hpp"

#include "runtime/channel.hpp"
#include "runtime/executive.hpp"
#include "runtime/hardware/bus_programs.hpp"
#include "runtime/kernel.hpp"

#include <algorithm>
#include <utility>

namespace placedpar::hardware {

MemoryLane::MemoryLane(Kernel& kernel, VmeMaster& master, DualPortedMemory& memory, From from, Cycles conversion)
    : kernel_(kernel), master_(master), memory_(memory), from_(from), conversion_(conversion) {}

void MemoryLane::output(AnyChannel& channel, const WireForm& form, const SourceLocation& where) {
    charge(kernel_.running(), &OperationCosts::hard_communication);
    bool master = from_ == From::master;
    std::int64_t left = form.total();
    do {
        std::int64_t bytes = std::min(left, buffer_bytes);
        left -= bytes;
        fill(bytes);
        bytes_ = bytes;
        last_ = left == 0;
        turn(true);
        channel.announce();
        wait_until(false, Activity::outputting, channel, where, master);
    } while (left > 0);
}

void MemoryLane::input(AnyChannel& channel, const SourceLocation& where) {
    charge(kernel_.running(), &OperationCosts::hard_communication);
    for (bool last = false; !last;) {
        wait_until(true, Activity::inputting, channel, where, from_ == From::memory);
        empty(bytes_);
        last = last_;
        if (last)
            channel.hand_over();
        turn(false);
    }
}

void MemoryLane::fill(std::int64_t bytes) {
    if (from_ == From::master)
        move_over_bus(bytes, master_.program().write_word);
    else
        copy_in_memory(bytes);
}

/// Copies a part of a message out of the buffer. A bus master then also writes a word over the bus, to mark the buffer
/// as empty.
void MemoryLane::empty(std::int64_t bytes) {
    if (from_ == From::master)
        return copy_in_memory(bytes);
    move_over_bus(bytes, master_.program().read_word);
    move_over_bus(4, master_.program().write_word);
}

void MemoryLane::move_over_bus(std::int64_t bytes, Cycles word) {
    std::uint64_t words = words_in(bytes), at_once = master_.program().in_blocks ? words : 1;
    for (std::uint64_t moved = 0; moved < words; moved += at_once) {
        if (word > Cycles{0})
            bus_programs::spend(kernel_, word);
        master_.move_words(memory_, at_once);
    }
}

void MemoryLane::copy_in_memory(std::int64_t bytes) {
    charge(kernel_.running(), [&](const OperationCosts& cost) {
        return cost.copy(bytes) + static_cast<std::int64_t>(words_in(bytes)) * conversion_;
    });
}

/// Waits until the buffer is full, or, if `full` is false, until it is empty. The sender and the receiver never wait at
/// the same time.
void MemoryLane::wait_until(bool full, Activity activity, AnyChannel& channel, const SourceLocation& where,
                            bool master) {
    if (full_ == full)
        return;
    waiting_ = &kernel_.running();
    waiting_->wait_for(activity, &channel, where);
    if (master && master_.program().interrupt > Cycles{0})
        bus_programs::spend(kernel_, master_.program().interrupt);
}

void MemoryLane::turn(bool full) {
    full_ = full;
    if (Process* process = std::exchange(waiting_, nullptr))
        kernel_.make_ready(*process);
}

} // namespace placedpar::hardware
