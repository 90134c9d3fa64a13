#include "netlist/kinds/device_kind.hpp"
#include "netlist/kinds/fault_kinds.hpp"
#include "netlist/print/buses_as_wires.hpp"
#include "netlist/print/pieces_as_wires.hpp"
#include "netlist/print/print.hpp"
#include "netlist/print/text.hpp"
#include "text/utf8.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

namespace placedpar {

namespace {

class DotPrinter {
public:
    explicit DotPrinter(Network network) : n_(std::move(network)), processes_of_(n_.nodes.size()) {
        for (std::size_t i = 0; i < n_.processes.size(); ++i)
            processes_of_[n_.processes[i].node].push_back(i);
        find_levels();
    }

    std::string print() {
        text_ = "graph network {\n"
                "  graph [rankdir=TB, nodesep=0.6, ranksep=0.7, bgcolor=\"white\", pad=0.3]\n"
                "  node [fontname=\"Helvetica\", fontsize=12, shape=plain]\n"
                "  edge [fontname=\"Helvetica\", fontsize=11, color=\"#3b5b7a\", fontcolor=\"#16324a\", "
                "penwidth=1.6, "
                "labeldistance=1.6]\n";
        for (std::size_t i = 0; i < n_.nodes.size(); ++i)
            print_node(i);
        auto channels = channels_carried();
        for (std::size_t i = 0; i < n_.connections.size(); ++i)
            print_connection(i, channels);
        return std::move(text_) + "}\n";
    }

private:
    /// Computes the rows of the drawing. A node's row is the number of wires between the node and the first row.
    void find_levels() {
        level_.assign(n_.nodes.size(), nowhere);
        auto neighbours = neighbours_of_nodes();
        for (bool first_row : {true, false})
            for (std::size_t start = 0; start < n_.nodes.size(); ++start)
                if (level_[start] == nowhere && (!first_row || n_.nodes[start].kind->drawing.in_first_row))
                    spread_from(start, neighbours);
    }

    using Neighbours = std::vector<std::vector<std::size_t>>;

    Neighbours neighbours_of_nodes() const {
        Neighbours neighbours(n_.nodes.size());
        for (const auto& connection : n_.connections) {
            neighbours[connection.a.node].push_back(connection.b.node);
            neighbours[connection.b.node].push_back(connection.a.node);
        }
        return neighbours;
    }

    void spread_from(std::size_t start, const Neighbours& neighbours) {
        std::vector<std::size_t> reached{start};
        level_[start] = 0;
        for (std::size_t i = 0; i < reached.size(); ++i)
            for (auto next : neighbours[reached[i]])
                if (level_[next] == nowhere) {
                    level_[next] = level_[reached[i]] + 1;
                    reached.push_back(next);
                }
    }

    void print_node(std::size_t index) {
        const auto& node = n_.nodes[index];
        const auto& drawing = node.kind->drawing;
        if (drawing.shape == Drawing::Shape::ellipse)
            text_ += fmt::format("  n{} [shape=ellipse, style=dashed, color=\"#777777\", fontcolor=\"#555555\", "
                                 "label=<{}>]\n",
                                 index, as_markup(node.name));
        bool is_set = drawing.shape == Drawing::Shape::crossed_box && is_set_at_run_time(n_, index);
        if (drawing.shape == Drawing::Shape::box || is_set)
            print_box(index, node, drawing);
    }

    void print_box(std::size_t index, const Node& node, const Drawing& drawing) {
        text_ += fmt::format(
            "  n{} [label=<<table border=\"0\" cellborder=\"1\" cellspacing=\"0\" cellpadding=\"5\" "
            "color=\"{}\"><tr><td bgcolor=\"{}\"><b>{}</b><br/><font point-size=\"10\">{}{}</font></td></tr>",
            index, drawing.frame, drawing.heading, as_markup(node.name), as_markup(node.type), print_drawn_facts(node));
        for (auto process : processes_of_[index])
            print_process(n_.processes[process]);
        if (node.runs_own_code && !node.image)
            text_ +=
                fmt::format("<tr><td bgcolor=\"#ffffff\"><font point-size=\"10\" color=\"#777777\">{}</font></td></tr>",
                            as_markup(print_boot(node)));
        for (const Fault& fault : n_.faults)
            if (fault.link < 0 && fault.node == index)
                text_ += fmt::format("<tr><td bgcolor=\"#ffffff\" border=\"3\" color=\"#16202a\"><b>{}</b></td></tr>",
                                     as_markup(print_fault_shortly(fault)));
        text_ += "</table>>]\n";
    }

    void print_process(const ProcessInstance& process) {
        auto kind = process.kind.empty() ? "no program" : as_markup(process.kind);
        text_ +=
            fmt::format("<tr><td bgcolor=\"#ffffff\" align=\"left\">{}{} <font point-size=\"10\" color=\"#777777\">{}"
                        "</font></td></tr>",
                        as_markup(process.name), process.high_priority ? " <b>!</b>" : "", kind);
    }

    static std::string link_label(const LinkEnd& end) {
        return end.at_edge() ? "" : end.link == configuration_link ? "config" : fmt::format("{}", end.link);
    }

    std::vector<std::size_t> channels_carried() const {
        std::vector<std::size_t> channels(n_.connections.size(), 0);
        for (const auto& channel : n_.channels)
            for (const RouteHop& hop : channel.placement.route)
                ++channels[hop.connection];
        return channels;
    }

    void print_connection(std::size_t index, const std::vector<std::size_t>& channels) {
        const auto& connection = n_.connections[index];
        std::string label;
        if (connection.bits_per_second != 20'000'000 && connection.bits_per_second != 0)
            label += fmt::format("{:g} Mbit/s", static_cast<double>(connection.bits_per_second) / 1e6);
        if (connection.switches() > 0)
            label += fmt::format("{}{} {}", label.empty() ? "" : ", ", connection.switches(),
                                 n_.nodes[connection.crossings[0].node].type);
        std::string faults;
        for (const Fault& fault : n_.faults)
            if (strikes(fault, connection))
                faults += (faults.empty() ? "" : ", ") + print_fault_shortly(fault);
        label += (label.empty() || faults.empty() ? "" : ", ") + faults;
        auto upper = connection.a, lower = connection.b;
        if (level_[upper.node] > level_[lower.node])
            std::swap(upper, lower);
        text_ +=
            fmt::format("  n{} -- n{} [taillabel=\"{}\", headlabel=\"{}\"{}{}{}]\n", upper.node, lower.node,
                        link_label(upper), link_label(lower), label.empty() ? "" : fmt::format(", label=\"{}\"", label),
                        !faults.empty() ? ", style=dashed, color=\"#16202a\", penwidth=3.5"
                        : channels[index] == 0 && !is_used_by_code(n_, connection) ? ", style=dotted"
                        : connection.at_run_time                                   ? ", style=dashed"
                                                                                   : "",
                        level_[upper.node] == level_[lower.node] ? ", constraint=false" : "");
    }

    Network n_;
    std::vector<std::vector<std::size_t>> processes_of_;
    std::vector<std::size_t> level_;
    std::string text_;
};

} // namespace

std::string print_dot(const Network& network) {
    return DotPrinter(with_buses_as_wires(with_pieces_as_wires(network))).print();
}

} // namespace placedpar
