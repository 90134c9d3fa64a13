#pragma once

#include <cstddef>

namespace placedpar {

/// Tells AddressSanitizer of every switch from one fiber's stack to another; otherwise it would report an exception as
/// a jump out of the stack. The program is asked while it runs: one that is compiled with the sanitizer may link rooms
/// that are not. Without the sanitizer, this does nothing.
///
/// 1. lies_at, once the stack's memory is known.
/// 2. To switch: leave_for(the other stack), then switch.
/// 3. On arrival: arrive; the first time arrive_from(the stack that was left).
class SwitchedStack {
public:
    /// Whether this program has AddressSanitizer.
    static bool is_watched();
    void leave_for(const SwitchedStack& to);
    void arrive();
    /// The first arrival, which also tells where the stack that was left lies.
    void arrive_from(SwitchedStack& from);
    void lies_at(const void* bottom, std::size_t bytes) { bottom_ = bottom, bytes_ = bytes; }

private:
    const void* bottom_ = nullptr;
    std::size_t bytes_ = 0;
    void* fake_stack_ = nullptr;
};

} // namespace placedpar
