#include "netlist/complete/complete.hpp"
#include "netlist/network/names.hpp"
#include "text/counted.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace placedpar {

namespace {

class Channels {
public:
    explicit Channels(Completion& c) : c_(c), bindings_(c.draft.processes.size()) {}

    void run() {
        for (std::size_t i = 0; i < c_.draft.channels.size(); ++i)
            add(i);
        for (std::size_t i = 0; i < bindings_.size(); ++i)
            if (!c_.kind_refused[i])
                finish_process(i);
        for (const auto& channel : c_.draft.edge_channels)
            if (!channel.connected)
                c_.reporter.warning(channel.declared,
                                    fmt::format("the edge channel \"{}\" is not connected", channel.name));
    }

private:
    struct End {
        Direction direction; ///< direction as a process at this end would see it: an edge channel that is declared
                             ///< `input` counts as an output
        const PortDescription* port = nullptr;
    };

    std::string shown(const DraftChannelEnd& end) const {
        return end.process == nowhere ? end.port : c_.draft.processes[end.process].name + "." + end.port;
    }

    /// Returns the port and the direction of a channel's end. If the direction is unknown, reports an error, and
    /// returns nothing.
    std::optional<End> look_up(const DraftChannelEnd& end) {
        if (end.process == nowhere) {
            auto direction = c_.draft.edge_channels[end.edge_channel].direction;
            return End{direction == Direction::input ? Direction::output : Direction::input, nullptr};
        }
        const auto& process = c_.draft.processes[end.process];
        const auto* kind = c_.kinds[end.process];
        const auto* port = kind == nullptr ? nullptr : kind->port(base_name(end.port));
        const auto* declared = process.interface ? find_named(process.interface->ports, base_name(end.port)) : nullptr;
        if (declared != nullptr)
            return End{declared->direction, port};
        if (port != nullptr)
            return End{port->direction, port};
        if (!c_.kind_refused[end.process])
            refuse_unknown(end, process, kind);
        return std::nullopt;
    }

    void refuse_unknown(const DraftChannelEnd& end, const DraftProcess& process, const ProcessKind* kind) {
        misnamed_.insert(end.process);
        if (kind == nullptr)
            return c_.reporter.error(end.at,
                                     fmt::format("the process \"{}\" has no channel \"{}\"", process.name, end.port),
                                     "declare its interface: process (interface (input in, output out)) name;",
                                     {{"the process is declared here", process.declared}});
        c_.reporter.error(end.at,
                          fmt::format("the kind \"{}\" of \"{}\" has no channel \"{}\"", kind->name, process.name,
                                      base_name(end.port)),
                          kind->hint_at_port(base_name(end.port)));
    }

    void add(std::size_t index) {
        const auto& draft = c_.draft.channels[index];
        for (const auto* end : {&draft.a, &draft.b})
            mentioned_.emplace(end->process, std::string(base_name(end->port)));
        auto a = look_up(draft.a), b = look_up(draft.b);
        if (!a || !b) {
            refused_ = true;
            return;
        }
        if (a->direction == b->direction)
            return refuse_direction(draft, a->direction);
        if (a->port != nullptr && b->port != nullptr && !agree(*a->port, *b->port))
            refuse_protocols(draft, *a->port, *b->port);
        bool forwards = a->direction == Direction::output;
        const auto &from = forwards ? draft.a : draft.b, &to = forwards ? draft.b : draft.a;
        bind(from, Direction::output);
        bind(to, Direction::input);
        add_channel({.name = draft.connection != nowhere ? c_.draft.connections[draft.connection].name
                                                         : fmt::format("{} -> {}", shown(from), shown(to)),
                     .from = end_of(from),
                     .to = end_of(to),
                     .placement = {},
                     .connected = draft.at},
                    index);
    }

    void add_channel(NetworkChannel channel, std::size_t draft) {
        c_.network.channels.push_back(std::move(channel));
        c_.draft_channel.push_back(draft);
    }

    /// Returns whether a channel may join the two ports. Two processes in occam must use the same protocol. A process
    /// in occam and a process in C++ must use messages that consist of the same bytes.
    static bool agree(const PortDescription& a, const PortDescription& b) {
        if (a.type != b.type)
            return std::ranges::find(a.byte_types, b.bytes_as) != a.byte_types.end() ||
                   std::ranges::find(b.byte_types, a.bytes_as) != b.byte_types.end();
        return a.make_channel || a.protocol == b.protocol;
    }

    void refuse_protocols(const DraftChannel& draft, const PortDescription& a, const PortDescription& b) {
        c_.reporter.error(draft.at, fmt::format("the protocols differ: \"{}\" carries {}, but \"{}\" carries {}",
                                                shown(draft.a), a.protocol, shown(draft.b), b.protocol));
    }

    void refuse_direction(const DraftChannel& draft, Direction direction) {
        refused_ = true;
        if (draft.a.process != nowhere && draft.b.process != nowhere)
            return c_.reporter.error(draft.b.at,
                                     fmt::format("two {}s are connected: \"{}\" and \"{}\"", word(direction),
                                                 shown(draft.a), shown(draft.b)),
                                     "a channel leads from an output to an input");
        const auto& edge = draft.a.process == nowhere ? draft.a : draft.b;
        const auto& process = draft.a.process == nowhere ? draft.b : draft.a;
        c_.reporter.error(
            draft.b.at,
            fmt::format("the edge channel \"{}\" is an {} of the network, but \"{}\" is an {} of its process",
                        edge.port, word(c_.draft.edge_channels[edge.edge_channel].direction), shown(process),
                        word(direction)),
            "connect an input of the network to an input of a process, and an output to an output");
    }

    ChannelEnd end_of(const DraftChannelEnd& end) const {
        if (end.process == nowhere)
            return {nowhere, end.port, c_.draft.edge_channels[end.edge_channel].edge};
        return {end.process, end.port, c_.draft.processes[end.process].node};
    }

    void bind(const DraftChannelEnd& end, Direction direction) {
        if (end.process != nowhere)
            bindings_[end.process].push_back({end.port, direction, c_.network.channels.size()});
    }

    /// Adds the channel of a port that no `connect` names, but that is placed on a link to an edge or to a processor
    /// that executes machine code. For edges, INMOS's configurer icconf accepts this form, too.
    void add_placed(std::size_t index, Direction direction, const std::string& name, const DraftPlacement& placement) {
        const auto& process = c_.draft.processes[index];
        std::size_t beyond = edge_behind(placement.where);
        if (beyond == nowhere)
            beyond = code_behind(placement.where);
        if (beyond == nowhere)
            return refuse_placed(process, name, placement);
        if (c_.network.nodes[beyond].runs_own_code && !can_lead_to_code(index, name, placement, beyond))
            return;
        ChannelEnd inner{index, name, process.node}, outer{nowhere, "", beyond};
        auto inner_name = process.name + "." + name;
        const auto& outer_name = c_.network.nodes[beyond].name;
        bool out = direction == Direction::output;
        bind({index, nowhere, name, placement.at}, direction);
        add_channel({.name = out ? inner_name + " -> " + outer_name : outer_name + " -> " + inner_name,
                     .from = out ? inner : outer,
                     .to = out ? outer : inner,
                     .placement = {},
                     .connected = placement.at},
                    nowhere);
    }

    /// Returns the edge at `end`, or the edge to which its link leads; nowhere if there is no edge.
    std::size_t edge_behind(const LinkEnd& end) const {
        auto wire = c_.connection_at.find({end.node, end.link});
        if (wire == c_.connection_at.end())
            return end.at_edge() && c_.network.nodes[end.node].kind->links == LinkRole::edge ? end.node : nowhere;
        const auto& connection = c_.network.connections[wire->second];
        return connection.a.at_edge() ? connection.a.node : connection.b.at_edge() ? connection.b.node : nowhere;
    }

    /// Returns the processor to which the link leads, if this processor executes machine code; otherwise nowhere.
    std::size_t code_behind(const LinkEnd& end) const {
        auto wire = c_.connection_at.find({end.node, end.link});
        if (wire == c_.connection_at.end())
            return nowhere;
        const auto& connection = c_.network.connections[wire->second];
        std::size_t other = connection.a.node == end.node ? connection.b.node : connection.a.node;
        return c_.network.nodes[other].runs_own_code && !has_image(other) ? other : nowhere;
    }

    /// Returns whether processes in occam are placed on the processor. A channel to such a process needs a `connect`
    /// statement: placing the channel on a link to the processor is not enough.
    bool has_image(std::size_t node) const {
        for (std::size_t i = 0; i < c_.draft.processes.size(); ++i)
            if (c_.draft.processes[i].node == node && c_.kinds[i] != nullptr && c_.kinds[i]->is_code)
                return true;
        return false;
    }

    /// Returns whether the channel can lead to the processor, which executes machine code. Otherwise reports the
    /// reason.
    bool can_lead_to_code(std::size_t index, const std::string& name, const DraftPlacement& placement,
                          std::size_t node) {
        const DraftProcess& process = c_.draft.processes[index];
        const ProcessKind* kind = c_.kinds[index];
        const PortDescription* port = kind == nullptr ? nullptr : kind->port(base_name(name));
        const Node& here = c_.network.nodes[placement.where.node];
        const bool at_run_time =
            c_.network.connections[c_.connection_at.at({placement.where.node, placement.where.link})].at_run_time;
        if (at_run_time || here.kind->executes == Execution::none) {
            c_.reporter.error(
                placement.at,
                fmt::format("the channel \"{}.{}\" cannot lead to \"{}\", which executes its own code, {}",
                            process.name, name, c_.network.nodes[node].name,
                            at_run_time ? "through a switch that is set during the run"
                                        : fmt::format("from \"{}\", {}", here.name, here.kind->noun)),
                "such a channel needs a wire between two processors, or from a workstation");
            return false;
        }
        if (port == nullptr || port->has_byte_form)
            return true;
        c_.reporter.error(
            placement.at,
            fmt::format("the channel \"{}.{}\" of the kind \"{}\" carries {}, which cannot travel as "
                        "bytes, but the code that \"{}\" executes can send and receive only bytes",
                        process.name, name, kind->name, port->protocol, c_.network.nodes[node].name),
            "these can travel as bytes: numbers and truth values, arrays and counted arrays of them, variants "
            "of all these, and the packets of the csp kinds");
        return false;
    }

    void refuse_placed(const DraftProcess& process, const std::string& port, const DraftPlacement& placement) {
        if (c_.network.nodes[placement.where.node].runs_own_code)
            return refuse_placed_at_code(process, port, placement);
        c_.reporter.error(placement.at,
                          fmt::format("the channel \"{}.{}\" is placed but not connected", process.name, port),
                          fmt::format("connect {}.{} to ...;", process.name, port));
    }

    /// Refuses a channel that is placed on a link of a processor that executes machine code. If the wire at this link
    /// leads to the processor of the channel's process, the hint names the link there.
    void refuse_placed_at_code(const DraftProcess& process, const std::string& port, const DraftPlacement& placement) {
        const std::string channel = process.name + "." + port;
        auto wire = c_.connection_at.find({placement.where.node, placement.where.link});
        std::string hint = "place the channel on a link of the processor with the process";
        if (wire != c_.connection_at.end())
            for (const LinkEnd& end : {c_.network.connections[wire->second].a, c_.network.connections[wire->second].b})
                if (end.node == process.node)
                    hint = fmt::format("place {} on {};", channel, link_name(c_.network.nodes, end));
        c_.reporter.error(placement.at,
                          fmt::format("the channel \"{}\" is placed on a link of \"{}\", which executes its own code: "
                                      "place it on the link at the process's end of the wire",
                                      channel, c_.network.nodes[placement.where.node].name),
                          hint);
    }

    void finish_process(std::size_t index) {
        const auto& process = c_.draft.processes[index];
        if (process.interface)
            check_interface(index, *process.interface);
        else if (c_.kinds[index] != nullptr)
            check_kind(index, *c_.kinds[index]);
        if (c_.kinds[index] != nullptr)
            check_elements(index, *c_.kinds[index]);
        auto& bindings = bindings_[index];
        std::stable_sort(bindings.begin(), bindings.end(), [&](const PortBinding& x, const PortBinding& y) {
            auto key = [&](const PortBinding& b) { return std::pair(order(index, b.port), subscripts_of(b.port)); };
            return key(x) < key(y);
        });
        c_.network.processes[index].ports = bindings;
    }

    /// Returns the position of the port among the ports of the process's kind. If the kind is unknown, returns the
    /// position in the declared interface.
    std::size_t order(std::size_t index, std::string_view port) const {
        auto position = [&](const auto& ports) {
            return static_cast<std::size_t>(find_named(ports, base_name(port)) - ports.data());
        };
        const auto* kind = c_.kinds[index];
        return kind != nullptr ? position(kind->ports) : position(c_.draft.processes[index].interface->ports);
    }

    void check_interface(std::size_t index, const Interface& interface) {
        std::set<std::string> bound;
        for (const auto& binding : bindings_[index])
            bound.insert(binding.port);
        for (const auto& port : interface.ports)
            for (std::size_t i = 0; i < element_count(port.dimensions); ++i) {
                auto name = element_name(port.name, element_subscripts(i, port.dimensions));
                if (bound.contains(name))
                    continue;
                if (auto placed = c_.draft.placements.find({index, name}); placed != c_.draft.placements.end())
                    add_placed(index, port.direction, name, placed->second.front());
                else if (!is_optional(index, port.name))
                    refuse_unconnected(index, port.at, name);
            }
    }

    bool is_optional(std::size_t index, const std::string& port) const {
        const auto* known = c_.kinds[index] == nullptr ? nullptr : c_.kinds[index]->port(port);
        return known != nullptr && known->optional;
    }

    /// Reports an unconnected channel, if no earlier error can be the cause. If a `connect` names the channel, a
    /// refused `connect` can be the cause. If no `connect` names it, a `connect` that names a channel that the process
    /// does not have can be the cause.
    void refuse_unconnected(std::size_t index, const Location& at, const std::string& port) {
        if (mentioned_.contains({index, std::string(base_name(port))}) ? refused_ : misnamed_.contains(index))
            return;
        const auto& process = c_.draft.processes[index];
        c_.reporter.error(at, fmt::format("the channel \"{}.{}\" is neither connected nor placed", process.name, port),
                          fmt::format("connect {}.{} to ...;", process.name, port));
    }

    /// Checks a process for which the netlist declares no interface: each port that its kind requires must be connected
    /// or placed.
    void check_kind(std::size_t index, const ProcessKind& kind) {
        const auto& process = c_.draft.processes[index];
        check_placed(index, kind);
        for (const auto& port : kind.ports) {
            auto used = subscripts_used(index, port.name);
            if (used.empty() && !port.optional && !is_placed(index, port.name))
                refuse_unconnected(index, process.declared, port.name);
            if (!check_numbering(process, port.name, used))
                return;
        }
    }

    /// Returns the subscripts of the connected elements of a port, in ascending order.
    std::vector<std::vector<std::int64_t>> subscripts_used(std::size_t index, const std::string& port) const {
        std::vector<std::vector<std::int64_t>> used;
        for (const auto& binding : bindings_[index])
            if (base_name(binding.port) == port)
                used.push_back(subscripts_of(binding.port));
        std::ranges::sort(used);
        return used;
    }

    /// Returns true if the port is connected without subscripts, or its connected elements are numbered 0, 1, 2 ...
    /// Otherwise reports an error and returns false.
    bool check_numbering(const DraftProcess& process, const std::string& port,
                         const std::vector<std::vector<std::int64_t>>& used) {
        for (std::size_t i = 0; i < used.size(); ++i)
            if (!used[i].empty() && (used[i].size() > 1 || used[i][0] != static_cast<std::int64_t>(i))) {
                c_.reporter.error(
                    process.declared,
                    fmt::format("the channels {}[...] of \"{}\" are not numbered 0, 1, 2 ...", port, process.name),
                    fmt::format("{}[{}] is not connected", port, i));
                return false;
            } else if (used[i].empty() && used.size() > 1) {
                c_.reporter.error(process.declared,
                                  fmt::format("the channel \"{}\" of \"{}\" is connected both with and without a "
                                              "subscript",
                                              port, process.name));
                return false;
            }
        return true;
    }

    /// Reports each port of fixed size that is connected with another number of channels.
    void check_elements(std::size_t index, const ProcessKind& kind) {
        const DraftProcess& process = c_.draft.processes[index];
        for (const PortDescription& port : kind.ports) {
            const std::size_t used = port.elements == 0 ? 0 : subscripts_used(index, port.name).size();
            if (used == 0 || std::cmp_equal(port.elements, used))
                continue;
            c_.reporter.error(process.declared,
                              fmt::format("the kind \"{}\" of \"{}\" has {} \"{}\", but {} connected", kind.name,
                                          process.name, counted(static_cast<std::size_t>(port.elements), "channel"),
                                          port.name, used == 1 ? "1 is" : fmt::format("{} are", used)),
                              std::cmp_less(used, port.elements)
                                  ? fmt::format("connect {}.{}[{}] to ...;", process.name, port.name, used)
                                  : "");
        }
    }

    /// Checks a process for which the netlist declares no interface: each placed channel must be connected, or lead to
    /// an edge or to the machine code of a processor.
    void check_placed(std::size_t index, const ProcessKind& kind) {
        const auto& placements = c_.draft.placements;
        for (auto placed = placements.lower_bound({index, ""});
             placed != placements.end() && placed->first.first == index; ++placed) {
            const auto& port = placed->first.second;
            if (is_bound(index, port))
                continue;
            if (const auto* known = kind.port(base_name(port)))
                add_placed(index, known->direction, port, placed->second.front());
            else
                refuse_placed(c_.draft.processes[index], port, placed->second.front());
        }
    }

    bool is_placed(std::size_t index, const std::string& port) const {
        const auto& placements = c_.draft.placements;
        for (auto placed = placements.lower_bound({index, port});
             placed != placements.end() && placed->first.first == index; ++placed)
            if (base_name(placed->first.second) == port)
                return true;
        return false;
    }

    bool is_bound(std::size_t index, const std::string& port) const {
        return std::ranges::find(bindings_[index], port, &PortBinding::port) != bindings_[index].end();
    }

    Completion& c_;
    std::vector<std::vector<PortBinding>> bindings_;
    std::set<std::pair<std::size_t, std::string>> mentioned_; ///< process and port of each end that a `connect` names
    std::set<std::size_t> misnamed_; ///< processes for which a `connect` names a channel that they lack
    bool refused_ = false;           ///< at least one `connect` was refused
};

} // namespace

void complete_channels(Completion& completion) { Channels(completion).run(); }

} // namespace placedpar
