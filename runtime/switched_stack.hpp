#pragma once

#include <cstddef>

#if defined(__SANITIZE_ADDRESS__)
#define PLACEDPAR_ADDRESS_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define PLACEDPAR_ADDRESS_SANITIZER 1
#endif
#endif

#if defined(PLACEDPAR_ADDRESS_SANITIZER)
#include <sanitizer/common_interface_defs.h>
#endif

namespace placedpar {

/// Tells AddressSanitizer of every switch from one fiber's stack to another; otherwise it would report an exception as
/// a jump out of the stack. Compiled without the sanitizer, this does nothing.
///
/// 1. lies_at, once the stack's memory is known.
/// 2. To switch: leave_for(the other stack), then switch.
/// 3. On arrival: arrive; the first time arrive_from(the stack that was left).
class SwitchedStack {
public:
#if defined(PLACEDPAR_ADDRESS_SANITIZER)
    static constexpr bool watched = true;
    void leave_for(const SwitchedStack& to) { __sanitizer_start_switch_fiber(&fake_stack_, to.bottom_, to.bytes_); }
    void arrive() { __sanitizer_finish_switch_fiber(fake_stack_, nullptr, nullptr); }
    /// The first arrival, which also tells where the stack that was left lies.
    void arrive_from(SwitchedStack& from) { __sanitizer_finish_switch_fiber(nullptr, &from.bottom_, &from.bytes_); }
    void lies_at(const void* bottom, std::size_t bytes) { bottom_ = bottom, bytes_ = bytes; }

private:
    const void* bottom_ = nullptr;
    std::size_t bytes_ = 0;
    void* fake_stack_ = nullptr;
#else
    static constexpr bool watched = false;
    void leave_for(const SwitchedStack&) {}
    void arrive() {}
    void arrive_from(SwitchedStack&) {}
    void lies_at(const void*, std::size_t) {}
#endif
};

} // namespace placedpar
