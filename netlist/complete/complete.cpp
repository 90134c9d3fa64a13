#include "netlist/complete/complete.hpp"

#include <set>

namespace placedpar {

std::string Completion::free_link(std::size_t node) const {
    std::set<int> used;
    for (const auto& wire : draft.wires)
        for (const auto& end : {wire.a, wire.b})
            if (end.node == node)
                used.insert(end.link);
    for (int link = 0; link < draft.links[node]; ++link)
        if (!used.contains(link))
            return link_name(network.nodes, {node, link});
    return "";
}

Network complete(Draft draft, const Catalogue& catalogue, Reporter& reporter, const CompiledPrograms& compiled) {
    Completion completion{std::move(draft), catalogue, reporter, compiled, {}, {}, {}, {}, {}, {}};
    completion.network.set = std::move(completion.draft.set);
    completion.network.nodes = std::move(completion.draft.nodes);
    place_code(completion);
    complete_hosts(completion);
    if (reporter.failed())
        return {};
    complete_wires(completion);
    complete_buses(completion);
    complete_processes(completion);
    complete_booted(completion);
    complete_channels(completion);
    complete_carriers(completion);
    complete_relays(completion);
    complete_faults(completion);
    if (!reporter.failed())
        complete_checks(completion);
    if (!reporter.failed())
        complete_images(completion);
    return std::move(completion.network);
}

} // namespace placedpar
