#include "netlist/complete/complete.hpp"

#include "netlist/kinds/own_code.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar {

namespace {

/// Finds the processor at an end of the named wire, whose other end is at a switch. The fault affects the link of that
/// processor, whichever partner the switch connects. If both ends are at switches, reports an error and returns false.
bool find_named_piece(Completion& c, const DraftFault& draft, std::size_t connection, Fault& fault) {
    auto piece = std::ranges::find(c.draft.wires, draft.connection, &DraftWire::connection);
    for (const LinkEnd& end : {piece->a, piece->b})
        if (c.connection_at.contains({end.node, end.link})) {
            fault.connection = connection;
            fault.node = end.node;
            fault.link = end.link;
            return true;
        }
    c.reporter.error(
        draft.at,
        fmt::format("the connection \"{}\" joins two switches that a program sets, so no processor is at its ends",
                    c.draft.connections[draft.connection].name),
        "state the fault at a link of a processor: fault root.link[0] silent;");
    return false;
}

/// Sets the fault's link to the end of the wire that `connect` names first, or to the other end if the first is an
/// edge. If the connection connects no links, reports an error, and returns false.
bool find_named_wire(Completion& c, const DraftFault& draft, Fault& fault) {
    auto named = c.connection_named.find(draft.connection);
    if (named == c.connection_named.end()) {
        c.reporter.error(
            draft.at,
            fmt::format("the connection \"{}\" connects no links", c.draft.connections[draft.connection].name),
            "connect ... to ... by connection;");
        return false;
    }
    const LinkConnection& wire = c.network.connections[named->second];
    if (wire.at_run_time)
        return find_named_piece(c, draft, named->second, fault);
    const LinkEnd& end = wire.a.at_edge() ? wire.b : wire.a;
    fault.connection = named->second;
    fault.node = end.node;
    fault.link = end.link;
    return true;
}

bool find_wire(Completion& c, const DraftFault& draft, Fault& fault) {
    auto wire = c.connection_at.find({fault.node, fault.link});
    if (wire == c.connection_at.end()) {
        bool crosses = c.network.nodes[fault.node].kind->links == LinkRole::crosses;
        c.reporter.error(draft.at,
                         fmt::format("{} \"{}\"",
                                     crosses ? "a fault is stated at an end of a wire, but this is a link of a switch:"
                                             : "no wire leads to the link",
                                     link_name(c.network.nodes, {fault.node, fault.link})));
        return false;
    }
    fault.connection = wire->second;
    return true;
}

void check_device(Completion& c, const DraftFault& draft) {
    const Fault& fault = draft.fault;
    const Node& node = c.network.nodes[fault.node];
    const FaultKind& kind = *std::ranges::find(node.kind->faults, fault.kind, &FaultKind::name);
    auto reason_against = [&] { return kind.why_not ? kind.why_not(c.network, fault) : ""; };
    if (std::string reason = ask_device(node, reason_against); !reason.empty())
        c.reporter.error(draft.at, reason);
}

} // namespace

void complete_faults(Completion& completion) {
    for (const DraftFault& draft : completion.draft.faults) {
        Fault fault = draft.fault;
        if (fault.link < 0)
            check_device(completion, draft);
        bool known = fault.link < 0 || (draft.connection != nowhere ? find_named_wire(completion, draft, fault)
                                                                    : find_wire(completion, draft, fault));
        if (known)
            completion.network.faults.push_back(std::move(fault));
    }
}

} // namespace placedpar
