#include "netlist/elaborate/elaborator.hpp"

#include "text/counted.hpp"
#include "text/nearest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace placedpar {

namespace {

/// Returns a hint that lists the process's channels, if it has an interface.
std::string channels_of(const DraftProcess& process) {
    constexpr std::size_t most = 5;
    if (!process.interface || process.interface->ports.empty())
        return "write " + process.name + ".channel";
    auto names = names_in(process.interface->ports);
    auto more = names.size() > most ? ", ..." : "";
    names.resize(std::min(names.size(), most));
    return fmt::format("its channels are {}{}", fmt::join(names, ", "), more);
}

} // namespace

Elaborator::Found Elaborator::find(const Reference& reference) {
    const auto* symbol = scopes_.find(reference.name);
    if (symbol == nullptr)
        refuse_undefined(reporter_, scopes_, reference.name, reference.at);
    const auto* things = std::get_if<DeclaredThings>(&symbol->meaning);
    if (things == nullptr)
        refuse(reference.at,
               fmt::format("\"{}\" is {}, which cannot be connected or placed", reference.name, describe(*symbol)));
    if (things->first != nowhere)
        return {things->category, things->dimensions, things->first};
    return {Category::node, {}, host(reference.at)};
}

/// Returns the predefined edge "host", and declares it at its first use.
std::size_t Elaborator::host(const Location& used) {
    if (host_ != nowhere)
        return host_;
    count_things(1, used);
    host_ = draft_.nodes.size();
    auto node = catalogue_.node_types().find("edge")->second.preset;
    node.name = claim_name("host");
    node.declared = used;
    draft_.nodes.push_back(std::move(node));
    draft_.links.push_back(0);
    return host_;
}

std::vector<std::int64_t> Elaborator::subscripts(const std::vector<ExpressionPointer>& expressions) {
    std::vector<std::int64_t> result;
    for (const auto& expression : expressions)
        result.push_back(evaluator_.integer(*expression, "a subscript").value);
    return result;
}

Elaborator::Elements Elaborator::elements(const Reference& reference, const Found& found) {
    const auto& sizes = found.dimensions;
    auto given = subscripts(reference.subscripts);
    if (given.size() > sizes.size())
        refuse(reference.subscripts[sizes.size()]->at,
               fmt::format("wrong number of subscripts: \"{}\" has {}, but the statement gives {}", reference.name,
                           sizes.size(), given.size()));
    Elements range{found.first, element_count(sizes)};
    for (std::size_t i = 0; i < given.size(); ++i) {
        if (given[i] < 0 || given[i] >= sizes[i])
            refuse(reference.subscripts[i]->at,
                   fmt::format("the subscript {} is outside of \"{}\"", given[i], reference.name),
                   fmt::format("expected from 0 to {}", sizes[i] - 1));
        range.count /= static_cast<std::size_t>(sizes[i]);
        range.first += static_cast<std::size_t>(given[i]) * range.count;
    }
    return range;
}

std::size_t Elaborator::element(const Reference& reference, const Found& found) {
    auto range = elements(reference, found);
    if (reference.subscripts.size() < found.dimensions.size())
        refuse(reference.at,
               fmt::format("\"{}\" is not completely subscripted: it has {}, but the statement gives {}",
                           reference.name, counted(found.dimensions.size(), "subscript"), reference.subscripts.size()),
               fmt::format("write all subscripts, such as {}",
                           element_name(reference.name, element_subscripts(0, found.dimensions))));
    return range.first;
}

/// Returns the link that a reference such as `t.link[2]` names, or the single link of an edge that it names.
LinkEnd Elaborator::link_end(const Reference& reference, const Found& found) {
    auto node = element(reference, found);
    const auto& declared = draft_.nodes[node];
    if (declared.kind->links != LinkRole::edge)
        return {node, link_number(reference, declared, draft_.links[node])};
    if (!reference.field.empty())
        refuse(reference.field_at,
               fmt::format("the edge \"{}\" has no links: connect to the edge itself", declared.name));
    return {node, -1};
}

int Elaborator::link_number(const Reference& reference, const Node& node, int links) {
    if (links == 0)
        refuse(reference.at, fmt::format("\"{}\" has no links: it is {}", node.name, with_article(node.type)),
               fmt::format("connect to one of its slots: connect sun.bus[0] to {}.slot[1];", node.name));
    if (reference.field.empty())
        refuse(reference.at, fmt::format("a link of \"{}\" must be named", node.name),
               fmt::format("write {}.link[...], with a number from 0 to {}", node.name, links - 1));
    if (reference.field == "config" && node.kind->is_set_by_link()) {
        if (!reference.field_subscripts.empty())
            refuse(reference.field_subscripts[0]->at, fmt::format("\"{}.config\" has no subscripts", node.name));
        return configuration_link;
    }
    if (reference.field != "link")
        refuse(reference.field_at, fmt::format("a node has no \"{}\"", reference.field),
               fmt::format("its links are {}.link[0] to {}.link[{}]", node.name, node.name, links - 1));
    auto given = subscripts(reference.field_subscripts);
    if (given.size() != 1)
        refuse(reference.field_at,
               fmt::format("wrong number of subscripts: \"link\" has 1, but the statement gives {}", given.size()),
               fmt::format("write {}.link[...], with a number from 0 to {}", node.name, links - 1));
    if (given[0] < 0 || given[0] >= links)
        refuse(reference.field_subscripts[0]->at, fmt::format("\"{}\" has no link {}", node.name, given[0]),
               fmt::format("a {} has the links 0 to {}", node.type, links - 1));
    return static_cast<int>(given[0]);
}

/// Returns the channel end that a reference such as `p.out[1]` names, or the edge channel that it names. If the netlist
/// declares no interface for a process, any port is accepted here. The port is checked later, when the kind of the
/// process is known.
DraftChannelEnd Elaborator::port_end(const Reference& reference, const Found& found) {
    auto index = element(reference, found);
    if (found.category == Category::edge_channel) {
        if (!reference.field.empty())
            refuse(reference.field_at, fmt::format("the edge channel \"{}\" has no parts", reference.name));
        return {nowhere, index, draft_.edge_channels[index].name, reference.at};
    }
    const auto& process = draft_.processes[index];
    if (reference.field.empty())
        refuse(reference.at, fmt::format("a channel of the process \"{}\" must be named", process.name),
               channels_of(process));
    auto given = subscripts(reference.field_subscripts);
    DraftChannelEnd end{index, nowhere, element_name(reference.field, given), reference.field_at};
    if (!process.interface) {
        if (std::pair key(index, end.port); !used_ports_.contains(key) && !draft_.placements.contains(key))
            count_things(1, reference.field_at);
        return end;
    }
    check_subscripts(declared_port(process, reference), reference, given);
    return end;
}

const PortDeclaration& Elaborator::declared_port(const DraftProcess& process, const Reference& reference) {
    if (const auto* port = find_named(process.interface->ports, reference.field))
        return *port;
    refuse_unknown_port(process, reference);
}

void Elaborator::check_subscripts(const PortDeclaration& port, const Reference& reference,
                                  const std::vector<std::int64_t>& given) {
    if (given.size() != port.dimensions.size())
        refuse(reference.field_at,
               fmt::format("{}: \"{}\" has {}, but the statement gives {}",
                           given.size() < port.dimensions.size() ? "subscripts of the channel are missing"
                                                                 : "wrong number of subscripts",
                           port.name, port.dimensions.size(), given.size()),
               "", {{"declared here", port.at}});
    for (std::size_t i = 0; i < given.size(); ++i)
        if (given[i] < 0 || given[i] >= port.dimensions[i])
            refuse(reference.field_subscripts[i]->at,
                   fmt::format("the subscript {} is outside of \"{}\"", given[i], port.name),
                   fmt::format("expected from 0 to {}", port.dimensions[i] - 1), {{"declared here", port.at}});
}

} // namespace placedpar
