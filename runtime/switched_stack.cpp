#include "runtime/switched_stack.hpp"

// These are functions of the sanitizers. All are weak here, so they are null in a program without a sanitizer. The last
// function tells ThreadSanitizer about a function call, and is called by compiled code. The others are declared in
// <sanitizer/common_interface_defs.h> and <sanitizer/tsan_interface.h>.
extern "C" {
[[gnu::weak]] void __sanitizer_start_switch_fiber(void** fake_stack, const void* bottom, std::size_t bytes);
[[gnu::weak]] void __sanitizer_finish_switch_fiber(void* fake_stack, const void** bottom_left, std::size_t* bytes_left);
[[gnu::weak]] void* __tsan_get_current_fiber();
[[gnu::weak]] void* __tsan_create_fiber(unsigned flags);
[[gnu::weak]] void __tsan_destroy_fiber(void* fiber);
[[gnu::weak]] void __tsan_switch_to_fiber(void* fiber, unsigned flags);
[[gnu::weak]] void __tsan_func_entry(void* caller);
}

namespace placedpar {

namespace {

bool has_address_sanitizer() { return __sanitizer_start_switch_fiber && __sanitizer_finish_switch_fiber; }
bool has_thread_sanitizer() { return __tsan_switch_to_fiber != nullptr; }

} // namespace

bool SwitchedStack::is_watched() { return has_address_sanitizer() || has_thread_sanitizer(); }

void SwitchedStack::leave_for(SwitchedStack& to) {
    if (has_address_sanitizer()) [[unlikely]]
        __sanitizer_start_switch_fiber(&fake_stack_, to.bottom_, to.bytes_);
    if (!has_thread_sanitizer()) [[likely]]
        return;
    fiber_ = __tsan_get_current_fiber();
    const bool is_new = !to.fiber_;
    if (is_new)
        to.fiber_ = __tsan_create_fiber(0);
    __tsan_switch_to_fiber(to.fiber_, 0);
    if (is_new) // the sanitizer will see the return from this function on the new fiber
        __tsan_func_entry(nullptr);
}

void SwitchedStack::arrive() {
    if (has_address_sanitizer()) [[unlikely]]
        __sanitizer_finish_switch_fiber(fake_stack_, nullptr, nullptr);
}

void SwitchedStack::arrive_from(SwitchedStack& from) {
    if (has_address_sanitizer()) [[unlikely]]
        __sanitizer_finish_switch_fiber(nullptr, &from.bottom_, &from.bytes_);
}

void SwitchedStack::gone() {
    if (has_thread_sanitizer() && fiber_) [[unlikely]]
        __tsan_destroy_fiber(fiber_);
    fiber_ = nullptr;
}

} // namespace placedpar
