#include "runtime/hardware/link_agenda.hpp"

#include "runtime/kernel.hpp"

#include <tuple>

namespace placedpar::hardware {

constexpr std::uint64_t ranks_of_a_link = 8;

constexpr std::array<LinkAgenda::Place, LinkAgenda::places> LinkAgenda::order{{
    {LinkStep::acknowledge_is_due, 0, EventQueue::request, 1},
    {LinkStep::acknowledge_is_due, 1, EventQueue::request, 5},
    {LinkStep::wire_is_free, 0, EventQueue::start, 0},
    {LinkStep::byte_is_due, 0, EventQueue::start, 1},
    {LinkStep::wire_is_free, 1, EventQueue::start, 4},
    {LinkStep::byte_is_due, 1, EventQueue::start, 5},
    {LinkStep::first_byte_arrives, 0, EventQueue::arrival, 1},
    {LinkStep::last_byte_arrives, 0, EventQueue::arrival, 2},
    {LinkStep::later_last_byte_arrives, 0, EventQueue::arrival, 2},
    {LinkStep::sending_ends, 0, EventQueue::arrival, 3},
    {LinkStep::first_byte_arrives, 1, EventQueue::arrival, 5},
    {LinkStep::last_byte_arrives, 1, EventQueue::arrival, 6},
    {LinkStep::later_last_byte_arrives, 1, EventQueue::arrival, 6},
    {LinkStep::sending_ends, 1, EventQueue::arrival, 7},
}};

/// The two tables are one, and sorted. (Of two last bytes that arrive at once it makes no difference which is first.)
constexpr bool LinkAgenda::in_order() {
    for (std::size_t i = 0; i < places; ++i) {
        if (place(order[i].step, order[i].direction) != i)
            return false;
        if (i > 0 && std::tie(order[i].priority, order[i].rank) < std::tie(order[i - 1].priority, order[i - 1].rank))
            return false;
    }
    return true;
}

LinkAgenda::LinkAgenda(Kernel& kernel, LinkWalker& walker)
    : walker_(walker), kernel_(kernel), first_rank_(kernel.new_ranks(ranks_of_a_link)) {
    static_assert(in_order());
    times_.fill(never);
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
    future.reschedule(*this, at, order[first].priority, first_rank_ + order[first].rank);
}

void LinkAgenda::happen() noexcept {
    const Place& now = order[first_];
    times_[first_] = never;
    walker_.take(now.step, now.direction);
    if (concerns_packets(now.step))
        walker_.plan();
    put_first();
}

} // namespace placedpar::hardware
