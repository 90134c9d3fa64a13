#include "picture/software.hpp"

#include "netlist/kinds/description.hpp"
#include "netlist/kinds/device_kind.hpp"
#include "picture/shapes.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace placedpar::picture {

namespace {

/// Returns a kind of device that stands for a process in the picture: a box with the process's kind and its processor.
std::shared_ptr<const DeviceKind> process_box(bool outside) {
    DeviceKind kind{.name = outside ? "process-outside" : "process",
                    .noun = "a process",
                    .about = "",
                    .attributes = {{.value = description::text("on", {.by_default = ""}, ""),
                                    .drawn = [](const Value& on) { return "on " + std::get<std::string>(on); }}},
                    .executes = Execution::in_time,
                    .drawing = {.frame = "#3b5b7a", .heading = "#d5e3f0", .legend = "process"}};
    if (outside)
        kind.drawing = {.frame = "#7a6a3b",
                        .heading = "#f3e9c9",
                        .in_first_row = true,
                        .legend = "process outside of the transputers"};
    return std::make_shared<const DeviceKind>(std::move(kind));
}

class SoftwareBuilder {
public:
    explicit SoftwareBuilder(const Network& network) : n_(network) {}

    Software build() {
        software_.network.source_path = n_.source_path;
        for (const ProcessInstance& process : n_.processes)
            add_process(process);
        for (const NetworkChannel& channel : n_.channels)
            add_channel(channel);
        if (auto hangs_from = find_tree(); !hangs_from.empty())
            software_.places = tree(hangs_from);
        return std::move(software_);
    }

private:
    void add_process(const ProcessInstance& process) {
        const Node& on = n_.nodes[process.node];
        Node node;
        node.name = process.name + (process.high_priority ? " !" : "");
        node.type = process.kind.empty() ? "no program" : process.kind;
        node.kind = on.kind->drawing.in_first_row ? outside_ : inside_;
        node.attributes["on"] = on.name;
        software_.network.nodes.push_back(std::move(node));
    }

    /// Returns the node that stands for a channel's end: a process or an edge. The first channel at an edge adds its
    /// node.
    std::size_t node_of(const ChannelEnd& end) {
        if (!end.at_edge())
            return end.process;
        auto [found, added] = edges_.emplace(end.node, software_.network.nodes.size());
        if (added)
            software_.network.nodes.push_back(n_.nodes[end.node]);
        return found->second;
    }

    void add_channel(const NetworkChannel& channel) {
        std::size_t from = node_of(channel.from), to = node_of(channel.to);
        NetworkChannel drawn = channel;
        drawn.from.node = from;
        drawn.to.node = to;
        if (from == to) {
            drawn.placement = {}; // a channel from a process to itself is counted inside the process's box
        } else {
            auto wire = wire_between(from, to);
            bool onward = software_.network.connections[wire].a.node == from;
            drawn.placement = {ChannelPlacement::Kind::link, {{wire, onward}}, false};
            Span& span = software_.spans[wire];
            std::string& label = onward ? span.from_label : span.to_label;
            label += (label.empty() ? "" : ", ") + channel.from.port;
        }
        software_.network.channels.push_back(std::move(drawn));
    }

    std::size_t wire_between(std::size_t from, std::size_t to) {
        auto [found, added] = wires_.emplace(std::minmax(from, to), software_.network.connections.size());
        if (added) {
            LinkConnection wire;
            wire.a.node = from;
            wire.b.node = to;
            software_.network.connections.push_back(wire);
            software_.spans.push_back({found->second, wire.a, wire.b, "", ""});
        }
        return found->second;
    }

    /// Returns the node to draw at the top: the first process outside of the transputers; if there is none, the first
    /// node.
    std::size_t find_top() const {
        const auto& nodes = software_.network.nodes;
        auto top = std::ranges::find_if(nodes, [](const Node& node) { return node.kind->drawing.in_first_row; });
        return top == nodes.end() ? 0 : static_cast<std::size_t>(top - nodes.begin());
    }

    /// Returns the parent of each node if the nodes form a tree with at least one branch; empty otherwise.
    std::vector<std::size_t> find_tree() const {
        const std::size_t nodes = software_.network.nodes.size();
        if (software_.spans.size() + 1 != nodes)
            return {};
        Wiring wiring(software_.network);
        std::vector<std::size_t> above(nodes, no_node), reached{find_top()};
        bool branches = false;
        for (std::size_t next = 0; next < reached.size() && reached.size() <= nodes; ++next) {
            std::size_t before = reached.size();
            for (auto other : wiring.neighbours(reached[next]))
                if (other != above[reached[next]]) {
                    above[other] = reached[next];
                    reached.push_back(other);
                }
            branches = branches || reached.size() > before + 1;
        }
        return branches && reached.size() == nodes ? above : std::vector<std::size_t>{};
    }

    const Network& n_;
    Software software_;
    std::shared_ptr<const DeviceKind> inside_ = process_box(false), outside_ = process_box(true);
    std::map<std::size_t, std::size_t> edges_; ///< drawn node of each edge
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> wires_;
};

} // namespace

Software software_of(const Network& network) { return SoftwareBuilder(network).build(); }

} // namespace placedpar::picture
