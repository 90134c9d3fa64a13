#include "runtime/hardware/wire.hpp"

#include "runtime/kernel.hpp"

#include <utility>

namespace placedpar::hardware {

Wire::Wire(Kernel& kernel, const LinkTiming& timing)
    : kernel_(kernel), timing_(timing), first_rank_(kernel.new_ranks(ranks_of_a_wire)) {}

void Wire::serve() {
    Time now = kernel_.now();
    if (now >= free_at_) {
        if (watch_)
            watch_->packet_begins();
        if (WireUser* user = std::exchange(acknowledge_for_, nullptr)) {
            free_at_ = later(now, timing_.acknowledge());
            user->acknowledge_started();
        } else if (WireUser* sender = std::exchange(byte_for_, nullptr)) {
            free_at_ = later(now, timing_.data());
            sender->byte_started();
        }
    }
    if ((acknowledge_for_ || byte_for_) && !freed_.scheduled())
        kernel_.future().schedule(freed_, free_at_, EventQueue::start, first_rank_);
}

} // namespace placedpar::hardware
