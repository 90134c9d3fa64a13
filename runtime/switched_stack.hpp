#pragma once

#include <cstddef>

namespace placedpar {

/// Tells AddressSanitizer of every switch from one fiber's stack to another, since otherwise it would report an
/// exception as a jump out of the stack. Whether the sanitizer is present is tested at run time, because a program
/// compiled with it may link rooms that are not. Without the sanitizer, this does nothing.
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
    /// Notes the first arrival, and where the stack that was left lies.
    void arrive_from(SwitchedStack& from);
    void lies_at(const void* bottom, std::size_t bytes) { bottom_ = bottom, bytes_ = bytes; }

private:
    const void* bottom_ = nullptr;
    std::size_t bytes_ = 0;
    void* fake_stack_ = nullptr;
};

} // namespace placedpar
