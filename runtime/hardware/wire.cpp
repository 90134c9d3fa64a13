#include "runtime/hardware/wire.hpp"

#include "runtime/kernel.hpp"

#include <utility>

namespace placedpar::hardware {

Wire::Wire(Kernel& kernel, const PacketTimes& times)
    : kernel_(kernel), first_rank_(kernel.new_ranks(ranks_of_a_wire)), times_(times) {}

void Wire::serve() {
    Time now = kernel_.now();
    if (now >= free_at_) {
        if (watch_)
            watch_->packet_begins();
        if (WireUser* user = std::exchange(acknowledge_for_, nullptr)) {
            free_at_ = later(now, times_.acknowledge);
            user->acknowledge_started();
        } else if (WireUser* sender = std::exchange(byte_for_, nullptr)) {
            free_at_ = later(now, times_.data);
            sender->byte_started();
        }
    }
    foresee_end();
}

void Wire::foresee_end() {
    if (!acknowledge_for_ && !byte_for_)
        return;
    EventQueue& future = kernel_.future();
    if (!freed_.scheduled() || future.time_of(freed_) != free_at_)
        future.reschedule(freed_, free_at_, EventQueue::start, first_rank_);
}

/// Whose packet was due has an event at the moment when the wire is free. It happens, though nobody waits any more: it
/// may be the last of a run that gets stuck. Who has asked early has none.
void Wire::withdraw(WireUser*& user, bool has_asked_early) {
    if (!user)
        return;
    foresee_end();
    user = nullptr;
    if (has_asked_early && !byte_for_ && !acknowledge_for_)
        kernel_.future().cancel(freed_);
}

void Wire::go_to(Time free_at, WireUser* byte_for, WireUser* acknowledge_for) {
    free_at_ = free_at;
    byte_for_ = byte_for;
    acknowledge_for_ = acknowledge_for;
    if (!byte_for_ && !acknowledge_for_)
        kernel_.future().cancel(freed_);
    else if (freed_.scheduled())
        foresee_end();
}

} // namespace placedpar::hardware
