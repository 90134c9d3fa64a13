#include "runtime/switched_stack.hpp"

// These functions are declared in <sanitizer/common_interface_defs.h>. Here they are weak, so they are null in a
// program without a sanitizer.
extern "C" {
[[gnu::weak]] void __sanitizer_start_switch_fiber(void** fake_stack, const void* bottom, std::size_t bytes);
[[gnu::weak]] void __sanitizer_finish_switch_fiber(void* fake_stack, const void** bottom_left, std::size_t* bytes_left);
}

namespace placedpar {

bool SwitchedStack::is_watched() { return __sanitizer_start_switch_fiber != nullptr; }

void SwitchedStack::leave_for(const SwitchedStack& to) {
    if (is_watched()) [[unlikely]]
        __sanitizer_start_switch_fiber(&fake_stack_, to.bottom_, to.bytes_);
}

void SwitchedStack::arrive() {
    if (is_watched()) [[unlikely]]
        __sanitizer_finish_switch_fiber(fake_stack_, nullptr, nullptr);
}

void SwitchedStack::arrive_from(SwitchedStack& from) {
    if (is_watched()) [[unlikely]]
        __sanitizer_finish_switch_fiber(nullptr, &from.bottom_, &from.bytes_);
}

} // namespace placedpar
