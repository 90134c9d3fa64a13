#include "runtime/hardware/wire.hpp"

#include "runtime/kernel.hpp"

#include <utility>

namespace placedpar::hardware {

Wire::Wire(Kernel& kernel, LinkAgenda& agenda, const PacketTimes& times, std::size_t number)
    : agenda_(agenda), kernel_(kernel), number_(static_cast<std::uint8_t>(number)), times_(times) {}

void Wire::serve() {
    Time now = kernel_.now();
    if (now < free_at_)
        return;
    step_stays_ = false;
    if (watch_)
        watch_->packet_begins();
    if (WireUser* user = std::exchange(acknowledge_for_, nullptr)) {
        free_at_ = later(now, times_.acknowledge().carried);
        user->acknowledge_started();
    } else if (WireUser* sender = std::exchange(byte_for_, nullptr)) {
        free_at_ = later(now, times_.byte().carried);
        sender->byte_started();
    }
}

void Wire::plan() {
    if (acknowledge_for_ || byte_for_)
        agenda_.enter(LinkStep::wire_is_free, number_, free_at_);
}

void Wire::withdraw(WireUser*& user, bool has_asked_early) {
    if (!user)
        return;
    plan();
    user = nullptr;
    step_stays_ = step_stays_ || !has_asked_early;
    if (!step_stays_ && !byte_for_ && !acknowledge_for_)
        agenda_.drop(LinkStep::wire_is_free, number_);
}

void Wire::go_to(Time free_at, WireUser* byte_for, WireUser* acknowledge_for) {
    step_stays_ = step_stays_ && free_at_ == free_at;
    free_at_ = free_at;
    byte_for_ = byte_for;
    acknowledge_for_ = acknowledge_for;
    if (!step_stays_ && !byte_for_ && !acknowledge_for_)
        agenda_.drop(LinkStep::wire_is_free, number_);
}

} // namespace placedpar::hardware
