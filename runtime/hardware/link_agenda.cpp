#include "runtime/hardware/link_agenda.hpp"

#include "runtime/kernel.hpp"

namespace placedpar::hardware {

namespace {

constexpr std::uint64_t ranks_of_a_link = 8;

struct Place {
    LinkStep step;
    std::size_t direction;
    EventQueue::Priority priority;
    std::uint64_t rank; ///< among those of the link
};

using enum LinkStep;

constexpr std::array in_order_of_an_instant{
    Place{acknowledge_is_due, 0, EventQueue::request, 1},
    Place{acknowledge_is_due, 1, EventQueue::request, 5},
    Place{wire_is_free, 0, EventQueue::start, 0},
    Place{byte_is_due, 0, EventQueue::start, 1},
    Place{wire_is_free, 1, EventQueue::start, 4},
    Place{byte_is_due, 1, EventQueue::start, 5},
    Place{first_byte_arrives, 0, EventQueue::arrival, 1},
    Place{last_byte_arrives, 0, EventQueue::arrival, 2},
    Place{later_last_byte_arrives, 0, EventQueue::arrival, 2},
    Place{sending_ends, 0, EventQueue::arrival, 3},
    Place{first_byte_arrives, 1, EventQueue::arrival, 5},
    Place{last_byte_arrives, 1, EventQueue::arrival, 6},
    Place{later_last_byte_arrives, 1, EventQueue::arrival, 6},
    Place{sending_ends, 1, EventQueue::arrival, 7},
};

} // namespace

LinkAgenda::LinkAgenda(Kernel& kernel, LinkWalker& walker)
    : walker_(walker), kernel_(kernel), first_rank_(kernel.new_ranks(ranks_of_a_link)) {
    times_.fill(never);
    static_assert([] {
        for (std::size_t i = 0; i < places; ++i)
            if (place(in_order_of_an_instant[i].step, in_order_of_an_instant[i].direction) != i)
                return false;
        return in_order_of_an_instant.size() == places;
    }());
}

void LinkAgenda::settle() {
    walker_.plan();
    put_first();
}

void LinkAgenda::put_first() {
    // Without branches, since the processor cannot foresee the outcome.
    std::uint64_t earliest = times_[0];
    std::size_t first = 0;
    for (std::size_t i = 1; i < places; ++i) {
        std::uint64_t time = times_[i];
        bool is_earlier = time < earliest;
        first = is_earlier ? i : first;
        earliest = is_earlier ? time : earliest;
    }
    EventQueue& future = kernel_.future();
    if (earliest == never)
        return future.cancel(*this);
    Time at{static_cast<std::int64_t>(earliest)};
    if (scheduled() && first == first_ && future.time_of(*this) == at)
        return;
    first_ = first;
    const Place& next = in_order_of_an_instant[first];
    future.reschedule(*this, at, next.priority, first_rank_ + next.rank);
}

void LinkAgenda::happen() noexcept {
    const Place& now = in_order_of_an_instant[first_];
    times_[first_] = never;
    walker_.take(now.step, now.direction);
    if (now.step < first_byte_arrives)
        walker_.plan();
    put_first();
}

} // namespace placedpar::hardware
