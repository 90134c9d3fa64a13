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

/// What is to come in one direction of a link, of its packets first. Its wire is the one that carries its bytes.
enum class LinkStep : std::uint8_t {
    acknowledge_is_due,
    wire_is_free,
    byte_is_due,
    first_byte_arrives,
    last_byte_arrives,
    later_last_byte_arrives, ///< the next part can start before the last byte of this one has arrived
    sending_ends
};

/// Whether it lets a packet begin, or ask for its wire; else something arrives.
constexpr bool concerns_packets(LinkStep step) { return step <= LinkStep::byte_is_due; }

/// Who takes these steps: the link.
class LinkWalker {
public:
    virtual void take(LinkStep, std::size_t direction) = 0;
    /// Enters those of the packets that are to come, and drops those that are not.
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
    /// link at once, also from within a step. After a step it is done, except that arrivals do not let the link plan:
    /// they change nothing for its packets, and come while these are in the closed form.
    void settle();

private:
    void happen() noexcept override;
    void put_first();

    struct Place {
        LinkStep step;
        std::size_t direction;
        EventQueue::Priority priority;
        std::uint64_t rank; ///< among those of the link
    };
    static constexpr std::size_t steps = 7, places = 2 * steps;
    /// In the order of an instant.
    static const std::array<Place, places> order;
    /// Where each stands in it, by step and direction.
    static constexpr std::size_t place_of[steps][2]{{0, 1}, {2, 4}, {3, 5}, {6, 10}, {7, 11}, {8, 12}, {9, 13}};
    static constexpr std::size_t place(LinkStep step, std::size_t direction) {
        return place_of[static_cast<std::size_t>(step)][direction];
    }
    static constexpr bool in_order();
    static constexpr std::uint64_t never = ~std::uint64_t{0};

    LinkWalker& walker_;
    Kernel& kernel_;
    std::uint64_t first_rank_;
    std::size_t first_ = places;                          ///< where that in the future stands
    alignas(64) std::array<std::uint64_t, places> times_; ///< in picoseconds
};

} // namespace placedpar::hardware
