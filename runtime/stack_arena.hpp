#pragma once

#include "runtime/switched_stack.hpp"

#include <cstddef>
#include <vector>

namespace placedpar {

/// A fiber's stack. Below the stack is a zone that detects an overflow, because it must not be written to. At the
/// stack's upper end is the object that manages the fiber (Worker).
struct Stack {
    std::byte* bottom = nullptr; ///< lowest address of the stack, at which the zone ends
    bool guarded = false;        ///< true: a write to the zone faults at once

    static constexpr std::size_t usual_bytes = 256 * 1024;
    /// Returns the size of a stack. It is larger with AddressSanitizer, which makes stack frames larger. Only the pages
    /// that a process touches take memory.
    static std::size_t bytes() { return SwitchedStack::is_watched() ? 4 * usual_bytes : usual_bytes; }
    /// The size of the zone. The zone is larger than most arrays, so an array that does not fit on the stack does not
    /// reach beyond the zone.
    static constexpr std::size_t zone_bytes = 64 * 1024;

    /// Returns whether a fault at the address is an overflow of this stack. If the zone is guarded, the address must be
    /// in the zone. Otherwise the address must be below the zone, and the zone must have been written to.
    bool was_left_for(const void* address) const;
    /// Returns whether the 64 bytes of the zone next to the stack, zeros at first, have been overwritten. For stacks
    /// that are not guarded.
    bool has_overflowed() const;
};

/// The memory of many stacks, reserved in large pieces. The operating system provides pages when they are touched. When
/// an arena is destroyed, the thread keeps the first piece for its next arena. The stacks in this piece are already
/// guarded, and their pages exist. This saves a tenth of a short run's time.
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
