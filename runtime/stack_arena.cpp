#include "runtime/stack_arena.hpp"

#include <sys/mman.h>

#include <algorithm>
#include <new>
#include <utility>

namespace placedpar {

namespace {

constexpr std::size_t stacks_in_a_piece = 256;

std::size_t slice_bytes() { return Stack::zone_bytes + Stack::bytes(); }
std::size_t piece_bytes() { return stacks_in_a_piece * slice_bytes(); }

/// The largest number of stacks that mprotect guards. With more stacks, a program would exceed the 65,530 mappings that
/// Linux allows.
constexpr std::size_t most_protected = 16'000;
/// MADV_GUARD_INSTALL of Linux 6.13, which Debian 12's headers do not define. Access to a guarded page raises SIGSEGV,
/// as with mprotect, but the guard does not split the mapping.
constexpr int guard_install = 102;

/// Guards a zone. Returns whether this was possible. `number`: how many zones have been guarded before.
bool guard_zone(std::byte* zone, std::size_t number) {
    if (SwitchedStack::is_watched())
        return false;
    return madvise(zone, Stack::zone_bytes, guard_install) == 0 ||
           (number < most_protected && mprotect(zone, Stack::zone_bytes, PROT_NONE) == 0);
}

bool is_written(const std::byte* begin, const std::byte* end) {
    return std::any_of(begin, end, [](std::byte each) { return each != std::byte{0}; });
}

} // namespace

bool Stack::was_left_for(const void* address) const {
    const std::byte* zone = bottom - zone_bytes;
    return guarded ? address >= zone && address < bottom : address < zone && is_written(zone, bottom);
}

bool Stack::has_overflowed() const { return is_written(bottom - 64, bottom); }

/// A piece of memory that a thread keeps for its next arena. Its memory is null if there is no such piece.
struct StackArena::Kept {
    ~Kept() {
        if (piece.memory)
            munmap(piece.memory, piece_bytes());
    }
    Piece piece;
};

StackArena::Kept& StackArena::kept() {
    thread_local Kept kept;
    return kept;
}

StackArena::~StackArena() {
    if (!pieces_.empty() && all_guarded_ && !kept().piece.memory)
        std::swap(kept().piece, pieces_.front());
    for (const Piece& piece : pieces_)
        if (piece.memory)
            munmap(piece.memory, piece_bytes());
}

Stack StackArena::allocate() {
    const std::size_t in_piece = allocated_ % stacks_in_a_piece;
    if (in_piece == 0)
        add_piece();
    Piece& piece = pieces_.back();
    std::byte* zone = piece.memory + in_piece * slice_bytes();
    bool guarded = in_piece < piece.guarded || guard_zone(zone, allocated_);
    ++allocated_;
    all_guarded_ &= guarded;
    if (guarded)
        piece.guarded = std::max(piece.guarded, in_piece + 1);
    return {zone + Stack::zone_bytes, guarded};
}

/// Adds a piece of memory without huge pages. A huge page would make several whole stacks resident.
void StackArena::add_piece() {
    pieces_.reserve(pieces_.size() + 1);
    if (kept().piece.memory) {
        pieces_.push_back(std::exchange(kept().piece, {}));
        return;
    }
    void* piece = mmap(nullptr, piece_bytes(), PROT_READ | PROT_WRITE,
                       MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE | MAP_STACK, -1, 0);
    if (piece == MAP_FAILED)
        throw std::bad_alloc();
    madvise(piece, piece_bytes(), MADV_NOHUGEPAGE);
    pieces_.push_back({static_cast<std::byte*>(piece)});
}

} // namespace placedpar
