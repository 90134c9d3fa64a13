#pragma once

#include <cstddef>

namespace placedpar {

/// Tells AddressSanitizer or ThreadSanitizer about every switch from one fiber's stack to another. Otherwise
/// AddressSanitizer would take an exception for a jump out of the stack, and ThreadSanitizer would mix up the calls of
/// different fibers. The class finds out at run time whether a sanitizer is present, because a program with a sanitizer
/// may link this library compiled without it. Without a sanitizer, the class does nothing.
///
/// 1. Call lies_at() once the stack's memory is known, and gone() when the stack is not used any more.
/// 2. To switch, call leave_for(the other stack), then switch.
/// 3. On arrival, call arrive(); the first time, call arrive_from(the stack that was left).
class SwitchedStack {
public:
    /// Returns whether this program runs with one of these sanitizers.
    static bool is_watched();
    void leave_for(SwitchedStack& to);
    void arrive();
    /// Handles the first arrival on this stack. Records the memory of the stack that was left.
    void arrive_from(SwitchedStack& from);
    void lies_at(const void* bottom, std::size_t bytes) { bottom_ = bottom, bytes_ = bytes; }
    void gone();

private:
    const void* bottom_ = nullptr;
    std::size_t bytes_ = 0;
    void* fake_stack_ = nullptr; ///< fake stack of AddressSanitizer
    void* fiber_ = nullptr;      ///< fiber of ThreadSanitizer
};

} // namespace placedpar
