#include "runtime/hardware/link_faults.hpp"

#include <algorithm>
#include <stdexcept>

namespace placedpar::hardware {

const FaultEffect& LinkFaults::add(const LinkFault& fault) {
    if (fault.from < Time{0} || fault.from >= fault.until || fault.factor < 1)
        throw std::logic_error(
            "a fault of a link must begin before it ends, and must slow the link down by a factor of at least 1");
    return faults_.emplace_back(Each{.fault = fault}).effect;
}

std::int64_t LinkFaults::bits_per_second(Time now) const {
    std::int64_t factor = 1;
    for (const Each& each : faults_)
        if (each.fault.kind == LinkFault::Kind::slow && each.acts(now))
            factor = std::max(factor, each.fault.factor);
    return std::max<std::int64_t>(bits_per_second_ / factor, 1);
}

bool LinkFaults::Each::strikes(const FaultEffect::Hit& packet, bool leaves_a) const {
    if (fault.kind == LinkFault::Kind::slow || !acts(packet.at) || !(leaves_a ? fault.wire_from_a : fault.wire_from_b))
        return false;
    return fault.kind == LinkFault::Kind::silent || packet.acknowledge;
}

bool LinkFaults::strike(const FaultEffect::Hit& packet, bool leaves_a) {
    for (Each& each : faults_) {
        const bool is_lost = each.strikes(packet, leaves_a);
        if (is_lost || (each.fault.kind == LinkFault::Kind::slow && each.acts(packet.at)))
            each.effect.first = each.effect.first.value_or(packet);
        if (is_lost) {
            ++(packet.acknowledge ? each.effect.acknowledges_lost : each.effect.bytes_lost);
            each.effect.last = packet;
            each.spent = each.fault.kind == LinkFault::Kind::loses_acknowledge;
            return true;
        }
    }
    auto closed = std::ranges::find_if(passages_, [&](const SwitchPath* each) { return !each->leads_on(leaves_a); });
    if (closed != passages_.end())
        (*closed)->lose(packet, leaves_a);
    return closed != passages_.end();
}

Time LinkFaults::Each::steady_until(Time now) const {
    if (spent || fault.until <= now)
        return Time::max();
    if (fault.from > now)
        return fault.from;
    bool slows_and_is_noted = fault.kind == LinkFault::Kind::slow && effect.first.has_value();
    return slows_and_is_noted ? fault.until : now;
}

Time LinkFaults::steady_until(Time now) const {
    if (!std::ranges::all_of(passages_, [](const SwitchPath* p) { return p->leads_on(true) && p->leads_on(false); }))
        return now;
    Time until = Time::max();
    for (const Each& each : faults_)
        until = std::min(until, each.steady_until(now));
    return until;
}

} // namespace placedpar::hardware
