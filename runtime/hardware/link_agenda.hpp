#pragma once

#include "runtime/event.hpp"
#include "runtime/time.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace placedpar {
class Kernel;
} // namespace placedpar

namespace placedpar::hardware {

/// What is to come in a direction of a link, in the order of an instant; of its wire it is what concerns the one that
/// carries its bytes.
enum class LinkStep : std::uint8_t {
    acknowledge_is_due,
    wire_is_free,
    byte_is_due,
    first_byte_arrives,
    last_byte_arrives,
    later_last_byte_arrives, ///< on a long wire the next part can start before the last byte of this one has arrived
    sending_ends
};

/// Who takes these steps: the link.
class LinkWalker {
public:
    virtual void take(LinkStep, std::size_t direction) = 0;
    /// Enters the packets that are to come. It is asked to after a step of one.
    virtual void plan() = 0;

protected:
    ~LinkWalker() = default;
};

/// All that is to come on a link, of which only the first stands in the kernel's future: the steps of a busy link are
/// put off and dropped more often than they are taken, and what a large machine waits for is the size of that queue.
class LinkAgenda final : private Event {
public:
    LinkAgenda(Kernel&, LinkWalker&);

    bool has(LinkStep step, std::size_t direction) const { return times_[place(step, direction)] != never; }
    /// In place of the moment at which it was to come, if it is there already.
    void enter(LinkStep step, std::size_t direction, Time at) {
        times_[place(step, direction)] = static_cast<std::uint64_t>(at.count());
    }
    void drop(LinkStep step, std::size_t direction) { times_[place(step, direction)] = never; }
    /// Lets the link plan, and puts its first step into the future. To be called after all that somebody does to the
    /// link at once; after a step it is done.
    void settle();

private:
    void happen() noexcept override;
    void put_first();

    static constexpr std::size_t places = 14; ///< two directions of seven steps
    /// They stand in the order of an instant: by EventQueue::Priority, in that by direction.
    static constexpr std::size_t place(LinkStep step, std::size_t direction) {
        auto number = static_cast<std::size_t>(step);
        return step < LinkStep::wire_is_free         ? direction
               : step < LinkStep::first_byte_arrives ? 1 + 2 * direction + number
                                                     : 3 + 4 * direction + number;
    }
    static constexpr std::uint64_t never = ~std::uint64_t{0};

    LinkWalker& walker_;
    Kernel& kernel_;
    std::uint64_t first_rank_;
    std::size_t first_ = places;
    alignas(64) std::array<std::uint64_t, places> times_;
};

} // namespace placedpar::hardware
