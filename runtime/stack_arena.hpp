#pragma once

#include "runtime/switched_stack.hpp"

#include <cstddef>
#include <vector>

namespace placedpar {

/// A fiber's stack. Below the stack is a zone that must not be written to. At the stack's upper end is its Worker.
struct Stack {
    std::byte* bottom = nullptr; ///< lowest address of the stack, at which the zone ends
    bool guarded = false;        ///< true: a write to the zone faults at once

    static constexpr std::size_t usual_bytes = 256 * 1024;
    /// Returns the size of a stack. Only the pages that a process touches take memory. AddressSanitizer's red zones
    /// make stack frames several times larger.
    static std::size_t bytes() { return SwitchedStack::is_watched() ? 4 * usual_bytes : usual_bytes; }
    /// The size of the zone. It is larger than most arrays. If an array does not fit on the stack, a write to it
    /// therefore reaches the zone, whichever element is written first.
    static constexpr std::size_t zone_bytes = 64 * 1024;

    /// Returns whether a fault at the address is an overflow of this stack. This is so if the address is in the guarded
    /// zone. If the zone is not guarded, it is so if the address is below the zone and the zone has been written to.
    bool was_left_for(const void* address) const;
    /// Returns whether the 64 bytes of the zone next to the stack, which are zeros at first, have been overwritten.
    /// Used for stacks that are not guarded.
    bool has_overflowed() const;
};

/// The memory of many stacks, reserved in large pieces. The operating system provides pages when they are touched. A
/// thread keeps the first piece of an arena for its next arena, because the stacks in this piece are already guarded
/// and touched. To guard and touch them again would take a tenth of a short run's time.
class StackArena {
public:
    StackArena() = default;
    ~StackArena();
    StackArena(const StackArena&) = delete;
    StackArena& operator=(const StackArena&) = delete;

    /// Returns a stack that exists as long as the arena. Its content is undefined, but its zone is all zeros. All
    /// stacks are guarded on Linux 6.13 or later, only the first 16,000 on earlier versions. Throws std::bad_alloc.
    Stack allocate();
    bool all_guarded() const { return all_guarded_; }

private:
    struct Piece {
        std::byte* memory = nullptr;
        std::size_t guarded = 0; ///< number of guarded stacks, which come first
    };
    struct Kept;
    static Kept& kept();
    void add_piece();

    std::vector<Piece> pieces_;
    std::size_t allocated_ = 0;
    bool all_guarded_ = true;
};

} // namespace placedpar
