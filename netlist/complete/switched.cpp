#include "netlist/complete/complete.hpp"

#include <fmt/format.h>

#include <tuple>

namespace placedpar {

namespace {

using UsersOfLinks = std::map<std::tuple<std::size_t, int, bool>,
                              const NetworkChannel*>; ///< key: node, link, and whether the channel outputs there

/// Registers the channel as a user of the link. Returns the channel of another process that uses the link already; null
/// if there is none.
const NetworkChannel* other_user(UsersOfLinks& users, const LinkEnd& link, bool outputs,
                                 const NetworkChannel& channel) {
    const auto* first = users.try_emplace({link.node, link.link, outputs}, &channel).first->second;
    bool same = outputs ? first->from.process == channel.from.process : first->to.process == channel.to.process;
    return same ? nullptr : first;
}

void refuse_sharing(Completion& c, const NetworkChannel& first, const NetworkChannel& second, const LinkEnd& link,
                    const char* what) {
    c.reporter.error(
        second.connected,
        fmt::format("{} the link \"{}\", which a switch connects during the run, on the channels \"{}\" and \"{}\"",
                    what, link_name(c.network.nodes, link), first.name, second.name),
        "a link switched at run time has one process that outputs and one that inputs; each of the two "
        "uses one channel for each partner",
        {{"the other channel is connected here", first.connected}});
}

} // namespace

/// Refuses a second user of a link that a switch connects to several partners in turn. In each direction, one process
/// may use such a link, and each connection carries one channel.
void check_switched(Completion& c) {
    const auto& wires = c.network.connections;
    UsersOfLinks users;
    std::map<std::pair<std::size_t, bool>, const NetworkChannel*> channels;
    for (const auto& channel : c.network.channels) {
        const auto& route = channel.placement.route;
        if (route.empty() || !wires[route.front().connection].at_run_time)
            continue;
        const RouteHop& hop = route.front();
        if (auto [first, alone] = channels.try_emplace({hop.connection, hop.from_a_to_b}, &channel); !alone)
            refuse_sharing(c, *first->second, channel, begin_of(hop, wires), "two channels use");
        else if (const auto* other = other_user(users, begin_of(hop, wires), true, channel))
            refuse_sharing(c, *other, channel, begin_of(hop, wires), "two processes output to");
        else if (const auto* another = other_user(users, end_of(hop, wires), false, channel))
            refuse_sharing(c, *another, channel, end_of(hop, wires), "two processes input from");
    }
}

} // namespace placedpar
