#include "netlist/kinds/device_kind.hpp"
#include "netlist/kinds/fault_kinds.hpp"
#include "netlist/network/names.hpp"
#include "netlist/print/print.hpp"
#include "netlist/print/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

namespace placedpar {

namespace {

using Out = std::back_insert_iterator<std::string>;

std::vector<std::string> print_others(const std::map<std::string, Value>& others) {
    std::vector<std::string> entries;
    for (const auto& [name, value] : others)
        entries.push_back(print_entry(name, value));
    return entries;
}

template <class Things>
std::vector<ElementRange> ranges_of(const Things& things) {
    return element_ranges(things.size(), [&](std::size_t i) { return std::string_view(things[i].name); });
}

/// Returns whether an include file of INMOS's toolset declares the type of the node.
bool is_declared_by_toolset(const Node& node) {
    return node.kind->name == "processor" || node.kind->links == LinkRole::edge;
}

enum class ParameterOrder { as_given, by_name };

/// Tells whether the routes are written as text, or only the bytes of their text are counted. Counting is the faster
/// way to find that a netlist is too large, because most of a large netlist consists of routes.
enum class Routes { written, counted };

/// Writes a network as a netlist without `rep` and `define`: each declaration states its own attributes. Also writes
/// the canonical form, whose hash identifies the network.
class CfsPrinter {
public:
    CfsPrinter(const Network& network, ParameterOrder order) : n_(network), order_(order) {}

    std::string print() { return print_declarations() + print_mapping(); }

    std::string print_declarations() {
        bool includes = n_.includes_toolset || std::ranges::any_of(n_.nodes, is_declared_by_toolset);
        if (order_ == ParameterOrder::as_given && includes)
            text_ += "#include \"setconf.inc\"\n\n";
        text_ += "/* hardware */\n";
        print_nodes();
        print_connections();
        print_wires();
        print_attachments();
        text_ += "\n/* software */\n";
        for (const Node& node : n_.nodes)
            if (!node.boot_file.empty())
                line("use {} for {};", boot_file(node), node.name);
        print_processes();
        print_edge_channels();
        for (const auto& channel : n_.channels)
            print_channel(channel);
        return std::exchange(text_, {});
    }

    /// Returns the part of the text that does not depend on the order of parameters: placements and routes.
    std::string print_mapping() {
        print_places();
        return std::exchange(text_, {});
    }

    /// Returns the number of bytes in the text of print_mapping(), without making the text of routes.
    std::size_t mapping_bytes() {
        routes_ = Routes::counted;
        print_places();
        routes_ = Routes::written;
        return std::exchange(text_, {}).size() + std::exchange(counted_, 0);
    }

private:
    /// Returns the path of a bootable file or, in the canonical form, the hash of its contents. The hash of the network
    /// thus changes if the program changes. It does not change if the file only moves.
    std::string boot_file(const Node& node) const {
        return order_ == ParameterOrder::as_given ? print_constant(node.boot_file)
                                                  : fmt::format("{:016x}", boot_hash(node));
    }

    /// Returns the program of a process. In the canonical form, the hash of a source file is in place of the file's
    /// name.
    std::string program(const ProcessInstance& process) const {
        return order_ == ParameterOrder::as_given || process.program_hash == 0
                   ? print_constant(process.kind)
                   : fmt::format("{:016x}{}", process.program_hash,
                                 process.kind.substr(std::min(process.kind.find('#'), process.kind.size())));
    }

    void print_places() {
        text_ += "\n/* mapping */\n";
        for (const auto& process : n_.processes)
            line("place {} on {};", process.name, n_.nodes[process.node].name);
        for (const auto& channel : n_.channels)
            print_carrier(channel);
        if (!n_.faults.empty())
            text_ += "\n/* faults */\n";
        for (const Fault& fault : n_.faults)
            line("fault {};", print_fault(fault, n_.nodes));
    }

    template <typename... Arguments>
    void line(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        fmt::format_to(Out(text_), format, std::forward<Arguments>(arguments)...);
        text_ += '\n';
    }

    void print_nodes() {
        for (const auto& range : ranges_of(n_.nodes)) {
            const auto& node = n_.nodes[range.first];
            if (order_ == ParameterOrder::as_given && is_predefined_host(range.first))
                continue;
            auto attributes = print_attributes(node);
            line("{} {}{}{};", node.type, print_list(attributes), attributes.empty() ? "" : " ", range.declarator);
            for (std::size_t i = range.first + 1; i < range.first + range.count; ++i)
                if (const auto others = print_attributes(n_.nodes[i], &node); !others.empty())
                    line("{} {};", n_.nodes[i].name, print_list(others));
        }
        for (const Node& node : n_.nodes)
            if (node.rank)
                line("{} (rank = {});", node.name, *node.rank);
    }

    /// Returns whether the node is the toolset's predefined edge "host", so that the text need not declare it. When the
    /// text is read, this edge becomes the last node. The result is therefore true only for the last node.
    bool is_predefined_host(std::size_t node) const {
        auto leads_there = [&](const LinkConnection& wire) { return wire.a.node == node || wire.b.node == node; };
        return n_.nodes[node].name == "host" && n_.nodes[node].kind->links == LinkRole::edge &&
               node + 1 == n_.nodes.size() && std::ranges::any_of(n_.connections, leads_there);
    }

    void print_connections() {
        std::vector<std::string> names;
        for (const auto& connection : n_.connections)
            if (!connection.name.empty())
                names.push_back(connection.name);
        for (const auto& piece : n_.pieces)
            if (!piece.name.empty())
                names.push_back(piece.name);
        for (const auto& attachment : n_.attachments)
            if (!attachment.name.empty())
                names.push_back(attachment.name);
        for (const auto& channel : n_.channels)
            if (is_named(channel))
                names.push_back(channel.name);
        for (const auto& declarator : declarators_of(names))
            line("connection {};", declarator);
    }

    static bool is_named(const NetworkChannel& channel) { return channel.name.find("->") == std::string::npos; }

    std::string end(const LinkEnd& at) const { return link_name(n_.nodes, at); }

    bool says_speed(const LinkConnection& connection) const {
        for (const auto& at : {connection.a, connection.b})
            if (!at.at_edge() && at.link != configuration_link &&
                n_.nodes[at.node].integer("linkspeed") != connection.bits_per_second)
                return true;
        return false;
    }

    void print_wires() {
        for (const auto& connection : n_.connections) {
            if (connection.over_bus || connection.at_run_time)
                continue; // these connections need no statement: attachments give the ways over buses, and pieces of
                          // wire give the connections that switches make
            std::vector<std::string> attributes;
            if (says_speed(connection))
                attributes.push_back(fmt::format("linkspeed = {}", connection.bits_per_second));
            if (connection.metres != 0)
                attributes.push_back(fmt::format("length = {}", print_constant(connection.metres)));
            if (!attributes.empty())
                line("{} {};", connection.name, print_list(attributes));
            auto from = connection.a;
            std::string by = connection.name.empty() ? "" : " by " + connection.name;
            for (const auto& crossing : connection.crossings) {
                LinkEnd in{crossing.node, crossing.from_link}, out{crossing.node, crossing.to_link};
                line("connect {} to {}{};", end(from), end(in), by);
                line("connect {} to {};", end(in), end(out));
                from = out;
                by.clear();
            }
            line("connect {} to {}{};", end(from), end(connection.b), by);
        }
        for (const auto& piece : n_.pieces)
            print_piece(piece);
        print_crosspoints_to_choose();
    }

    void print_piece(const WirePiece& piece) {
        std::vector<std::string> attributes;
        if (piece.bits_per_second)
            attributes.push_back(fmt::format("linkspeed = {}", *piece.bits_per_second));
        if (piece.metres != 0)
            attributes.push_back(fmt::format("length = {}", print_constant(piece.metres)));
        if (!attributes.empty())
            line("{} {};", piece.name, print_list(attributes));
        line("connect {} to {}{};", end(piece.a), end(piece.b), piece.name.empty() ? "" : " by " + piece.name);
    }

    /// Prints the crosspoints of the switches that programs set. Each crosspoint is printed once, although several
    /// connections may use it.
    void print_crosspoints_to_choose() {
        std::set<std::pair<std::string, std::string>> known;
        for (const auto& connection : n_.connections)
            for (const auto& crossing : connection.crossings) {
                std::string in = end({crossing.node, crossing.from_link}), out = end({crossing.node, crossing.to_link});
                if (connection.at_run_time && known.emplace(std::minmax(in, out)).second)
                    line("connect {} to {};", in, out);
            }
    }

    void print_attachments() {
        for (const auto& attachment : n_.attachments) {
            std::vector<std::string> attributes;
            if (attachment.level != BusAttachment{}.level)
                attributes.push_back(fmt::format("level = {}", attachment.level));
            if (attachment.on_request)
                attributes.push_back("release = \"ROR\"");
            if (!attributes.empty())
                line("{} {};", attachment.name, print_list(attributes));
            line("connect {} to {}.slot[{}]{};", end({attachment.node, bus_port}), n_.nodes[attachment.bus].name,
                 attachment.slot, attachment.name.empty() ? "" : " by " + attachment.name);
        }
    }

    void print_processes() {
        for (const auto& range : ranges_of(n_.processes)) {
            print_declaration(range);
            print_programs(range);
        }
    }

    void print_declaration(const ElementRange& range) {
        const auto begin = n_.processes.begin() + static_cast<std::ptrdiff_t>(range.first);
        const auto end = begin + static_cast<std::ptrdiff_t>(range.count);
        bool high = std::all_of(begin, end, [](const ProcessInstance& p) { return p.high_priority; });
        auto common = begin->other;
        std::erase_if(common, [&](const auto& entry) {
            return !std::all_of(begin, end, [&](const ProcessInstance& p) {
                auto found = p.other.find(entry.first);
                return found != p.other.end() && found->second == entry.second;
            });
        });
        auto attributes = print_others(common);
        if (high)
            attributes.insert(attributes.begin(), "priority = HIGH");
        if (auto interface = print_interface(range); !interface.empty())
            attributes.push_back(interface);
        line("process {}{}{};", print_list(attributes), attributes.empty() ? "" : " ", range.declarator);
        print_settings(range, common, high);
    }

    /// Returns the interface in the order of the netlist, since a C program may fetch its parameters by position.
    std::string print_interface(const ElementRange& range) const {
        const auto& interface = n_.processes[range.first].interface;
        std::vector<std::string> entries;
        if (interface != nullptr)
            for (const auto& entry : *interface)
                entries.push_back(entry.type + " " + element_name(entry.name, entry.dimensions));
        return entries.empty() ? "" : "interface " + print_list(entries);
    }

    using Entries = std::vector<std::string>; ///< "name = value"

    Entries settings(const ProcessInstance& process, const std::map<std::string, Value>& declared, bool all_high) {
        Entries entries;
        if (process.high_priority && !all_high)
            entries.push_back("priority = HIGH");
        for (const auto& [name, value] : process.other)
            if (!declared.contains(name))
                entries.push_back(print_entry(name, value));
        for (const std::string& name : parameters_in_order(process))
            entries.push_back(print_parameter(process.parameters, name));
        return entries;
    }

    /// Returns the names of the parameters that the netlist gives, in its order. Parameters that the netlist does not
    /// give are left out, since a kind may treat a given value differently from an equal default. With
    /// ParameterOrder::by_name, returns all parameters.
    std::vector<std::string> parameters_in_order(const ProcessInstance& process) const {
        std::vector<std::string> names;
        std::set<std::string_view> known; // names listed so far
        auto add = [&](std::string_view name) {
            if (known.insert(name).second)
                names.emplace_back(name);
        };
        if (order_ == ParameterOrder::as_given)
            for (const std::string& name : process.given_in_order)
                add(name);
        else
            for (const auto& [name, value] : process.parameters)
                add(base_name(name));
        return names;
    }

    static std::string print_parameter(const std::map<std::string, Value>& parameters, const std::string& name) {
        if (auto single = parameters.find(name); single != parameters.end())
            return print_entry(name, single->second);
        return fmt::format("{} = {}", name, print_array(parameters, name));
    }

    /// Prints the settings of an array's elements. A setting that all elements share is printed once for the array; the
    /// other settings follow, element by element.
    void print_settings(const ElementRange& range, const std::map<std::string, Value>& declared, bool all_high) {
        auto of = [&](std::size_t i) { return settings(n_.processes[range.first + i], declared, all_high); };
        Entries common = of(0);
        for (std::size_t i = 1; i < range.count && !common.empty(); ++i) {
            Entries others = of(i);
            std::set<std::string_view> here(others.begin(), others.end());
            std::erase_if(common, [&](const std::string& entry) { return !here.contains(entry); });
        }
        print_entries(range.base, common);
        std::set<std::string_view> said(common.begin(), common.end());
        for (std::size_t i = 0; i < range.count && range.count > 1; ++i) {
            Entries rest = of(i);
            std::erase_if(rest, [&](const std::string& entry) { return said.contains(entry); });
            print_entries(n_.processes[range.first + i].name, rest);
        }
    }

    void print_entries(const std::string& whose, const Entries& entries) {
        if (!entries.empty())
            line("{} {};", whose, print_list(entries));
    }

    /// Returns the elements "a[0]", "a[1]" ... as one constant, nested by dimension.
    static std::string print_array(const std::map<std::string, Value>& parameters, std::string_view base) {
        std::map<std::vector<std::int64_t>, std::string> elements;
        for (auto entry = parameters.lower_bound(std::string(base) + "["); entry != parameters.end(); ++entry) {
            if (base_name(entry->first) != base)
                break;
            elements[subscripts_of(entry->first)] = print_constant(entry->second);
        }
        std::string result;
        std::size_t line_begin =
            0; // offset of the present line, which is broken before it becomes too long to be read again
        std::vector<std::int64_t> last;
        for (const auto& [subscripts, text] : elements) {
            std::size_t same = 0;
            while (same < last.size() && last[same] == subscripts[same])
                ++same;
            if (!last.empty())
                result.append(last.size() - same - 1, '}').append(", ");
            if (result.size() - line_begin + text.size() > 90) {
                result.append("\n    ");
                line_begin = result.size();
            }
            result.append(last.empty() ? subscripts.size() : subscripts.size() - same - 1, '{').append(text);
            last = subscripts;
        }
        return result + std::string(last.size(), '}');
    }

    void print_programs(const ElementRange& range) {
        const auto& first = n_.processes[range.first].kind;
        bool same = true;
        for (std::size_t i = range.first; i < range.first + range.count; ++i)
            same = same && n_.processes[i].kind == first;
        for (std::size_t i = range.first; i < range.first + (same ? 1 : range.count); ++i)
            if (const auto& process = n_.processes[i]; !process.kind.empty())
                line("use {} for {};", program(process), same ? range.base : process.name);
    }

    void print_edge_channels() {
        for (bool inputs : {true, false}) {
            std::vector<std::string> names;
            for (const auto& channel : n_.channels)
                if (const auto& at = inputs ? channel.from : channel.to; at.at_edge() && !at.port.empty())
                    names.push_back(at.port);
            for (const auto& declarator : declarators_of(names))
                line("{} {};", inputs ? "input" : "output", declarator);
        }
    }

    std::string end(const ChannelEnd& at) const {
        return at.at_edge() ? at.port : n_.processes[at.process].name + "." + at.port;
    }

    void print_channel(const NetworkChannel& channel) {
        if (end(channel.from).empty() || end(channel.to).empty())
            return; // no statement is needed: the placement of the other end makes the channel
        line("connect {} to {}{};", end(channel.from), end(channel.to), is_named(channel) ? " by " + channel.name : "");
    }

    void print_carrier(const NetworkChannel& channel) {
        if (channel.placement.kind == ChannelPlacement::Kind::soft)
            return;
        for (const auto* at : {&channel.from, &channel.to})
            if (at->at_edge() && !at->port.empty())
                line("place {} on {};", at->port, n_.nodes[at->node].name);
        if (channel.placement.broadcast_on != nowhere)
            line("place {} on {};", end(channel.from), n_.nodes[channel.placement.broadcast_on].name);
        if (channel.placement.route.size() > 1)
            return print_route(channel);
        if (n_.connections[channel.placement.route.front().connection].over_bus)
            return print_way(channel);
        const auto& inner = channel.from.at_edge() ? channel.to : channel.from;
        const auto& connection = n_.connections[channel.placement.route.front().connection];
        bool at_a = connection.a.node == inner.node;
        line("place {} on {};", end(inner), end(at_a ? connection.a : connection.b));
        if (connection.at_run_time)
            line("place {} on {};", end(channel.to), end(at_a ? connection.b : connection.a));
    }

    void print_route(const NetworkChannel& channel) {
        const std::string sender = fmt::format("place {} on ", end(channel.from));
        for (const auto& hop : channel.placement.route) {
            const std::string& link = stated_name(hop);
            if (routes_ == Routes::counted)
                counted_ += sender.size() + link.size() + 2;
            else
                text_.append(sender).append(link).append(";\n");
        }
    }

    const std::string& stated_name(const RouteHop& hop) {
        stated_names_.resize(2 * n_.connections.size());
        std::string& name = stated_names_[2 * hop.connection + (hop.from_a_to_b ? 1 : 0)];
        if (name.empty())
            name = end(stated_end(hop));
        return name;
    }

    /// Returns the link that a `place` statement names for a hop. It is the link at which the hop begins. If the hop
    /// leads from a master over a link adapter, it is the link of the adapter, since a master may use several adapters.
    LinkEnd stated_end(const RouteHop& hop) const {
        const auto& way = n_.connections[hop.connection].over_bus;
        bool by_adapter = way && way->wire != nowhere && hop.from_a_to_b;
        return by_adapter ? LinkEnd{n_.attachments[way->slave].node, 0} : begin_of(hop, n_.connections);
    }

    /// Prints the way of a channel over a bus. A way over a link adapter is named by the adapter's link. A way to the
    /// memory of a bus master is printed only if another way joins the same nodes.
    void print_way(const NetworkChannel& channel) {
        const auto& way = n_.connections[channel.placement.route.front().connection];
        if (way.b.link != bus_port)
            line("place {} on {};", end(channel.from.node == way.b.node ? channel.from : channel.to), end(way.b));
        else if (have_other_ways(way))
            line("place {} on {};", end(channel.from), end(stated_end(channel.placement.route.front())));
    }

    bool have_other_ways(const LinkConnection& way) const {
        auto joins_them = [&](const LinkConnection& other) {
            return std::minmax(other.a.node, other.b.node) == std::minmax(way.a.node, way.b.node);
        };
        return std::ranges::count_if(n_.connections, joins_them) > 1;
    }

    const Network& n_;
    ParameterOrder order_;
    Routes routes_ = Routes::written;
    std::string text_;
    std::size_t counted_ = 0;               ///< bytes of the routes, if they are only counted
    std::vector<std::string> stated_names_; ///< two names for each connection: of the hop from b to a, then of the hop
                                            ///< from a to b; "" until used
};

} // namespace

std::string print_cfs(const Network& network) { return CfsPrinter(network, ParameterOrder::as_given).print(); }

std::string canonical_form(const Network& network) { return CfsPrinter(network, ParameterOrder::by_name).print(); }

WrittenOut write_out(const Network& network, std::size_t most_bytes) {
    CfsPrinter printer(network, ParameterOrder::as_given);
    WrittenOut out{.text = printer.print_declarations()};
    out.bytes = out.text.size() + printer.mapping_bytes();
    if (out.bytes > most_bytes)
        return {.bytes = out.bytes};
    const std::string mapping = printer.print_mapping();
    out.text += mapping;
    const std::string by_name = CfsPrinter(network, ParameterOrder::by_name).print_declarations();
    out.hash = network_hash(mapping, network_hash(by_name));
    return out;
}

} // namespace placedpar
