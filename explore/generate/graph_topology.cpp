#include "explore/generate/graph_topology.hpp"

#include "explore/generate/graph.hpp"
#include "netlist/elaborate/attributes.hpp"
#include "netlist/kinds/catalogue.hpp"
#include "netlist/kinds/device_kind.hpp"
#include "netlist/kinds/parameter.hpp"
#include "text/load_source.hpp"
#include "text/nearest.hpp"
#include "text/number.hpp"
#include "text/refused_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <set>
#include <utility>

namespace placedpar::generate {

namespace {

std::string ending_of(const std::string& path) { return lower_case(std::filesystem::path(path).extension().string()); }

std::shared_ptr<const SourceFile> load_graph_text(const std::string& path) {
    LoadedSource loaded = load_input(path);
    if (has_errors(loaded.problems))
        throw RefusedText(loaded.problems);
    return loaded.file;
}

/// Throws RefusedText if an edge and its opposite state different values for their wire.
void require_equal(const GraphEdge& edge, const GraphEdge& opposite, const std::shared_ptr<const SourceFile>& file) {
    for (const char* name : {"linkspeed", "speed", "length"}) {
        const auto here = edge.attributes.find(name), there = opposite.attributes.find(name);
        if (here != edge.attributes.end() && there != opposite.attributes.end() && here->second != there->second)
            refuse_graph(file, edge.line,
                         fmt::format("{} is {} here, but {} for the edge in the opposite direction, in line {}", name,
                                     here->second, there->second, opposite.line),
                         "give both edges the same value: they become one wire");
    }
}

/// Joins pairs of edges in opposite directions, because one link carries both directions.
void join_directions(Graph& graph, const std::shared_ptr<const SourceFile>& file) {
    std::multimap<std::pair<std::size_t, std::size_t>, std::size_t> single; // edges without an opposite edge so far
    std::vector<GraphEdge> kept;
    for (GraphEdge& edge : graph.edges) {
        const auto opposite = single.find({edge.to, edge.from});
        if (opposite != single.end()) {
            require_equal(edge, kept[opposite->second], file);
            kept[opposite->second].attributes.merge(edge.attributes);
            single.erase(opposite);
        } else {
            single.emplace(std::pair(edge.from, edge.to), kept.size());
            kept.push_back(std::move(edge));
        }
    }
    graph.edges = std::move(kept);
}

std::vector<std::vector<std::size_t>> edges_by_node(const Graph& graph) {
    std::vector<std::vector<std::size_t>> edges(graph.nodes.size());
    for (std::size_t i = 0; i < graph.edges.size(); ++i) {
        edges[graph.edges[i].from].push_back(i);
        edges[graph.edges[i].to].push_back(i);
    }
    return edges;
}

/// Returns a node's name with the names of its neighbours, such as `"hub" (to a, b, c, d, e)`.
std::string node_with_neighbours(const Graph& graph, std::size_t node, const std::vector<std::size_t>& edges) {
    std::vector<std::string> names;
    for (const std::size_t i : edges)
        names.push_back(graph.nodes[graph.edges[i].from == node ? graph.edges[i].to : graph.edges[i].from].name);
    constexpr std::size_t most = 8;
    const bool more = names.size() > most;
    names.resize(std::min(names.size(), most));
    return fmt::format("\"{}\" (to {}{})", graph.nodes[node].name, fmt::join(names, ", "), more ? ", ..." : "");
}

/// Throws RefusedText if a node has more than `most` edges. The message names the nodes.
void require_edges(const Graph& graph, const std::shared_ptr<const SourceFile>& file, std::size_t most,
                   const std::string& hint) {
    const auto edges = edges_by_node(graph);
    std::vector<std::string> nodes;
    std::size_t line = 0, count = 0;
    for (std::size_t node = 0; node < edges.size(); ++node)
        if (edges[node].size() > most && ++count <= 5) {
            line = line == 0 ? graph.nodes[node].line : line;
            nodes.push_back(node_with_neighbours(graph, node, edges[node]));
        }
    if (count > 0)
        refuse_graph(file, line,
                     fmt::format("{} more than {} edges: {}{}",
                                 count == 1 ? "a node has" : fmt::format("{} nodes have", count), most,
                                 fmt::join(nodes, "; "), count > nodes.size() ? "; ..." : ""),
                     hint);
}

/// Returns for each node whether edges lead to it from the first node.
std::vector<bool> reached_from_first(const Graph& graph) {
    const auto edges = edges_by_node(graph);
    std::vector<bool> reached(graph.nodes.size());
    std::vector<std::size_t> to_visit{0};
    reached[0] = true;
    while (!to_visit.empty()) {
        const std::size_t node = to_visit.back();
        to_visit.pop_back();
        for (const std::size_t i : edges[node])
            for (const std::size_t end : {graph.edges[i].from, graph.edges[i].to})
                if (!reached[end])
                    reached[end] = true, to_visit.push_back(end);
    }
    return reached;
}

/// Throws RefusedText if the graph consists of several parts. The message names the nodes.
void require_connected(const Graph& graph, const std::shared_ptr<const SourceFile>& file) {
    const std::vector<bool> reached = reached_from_first(graph);
    std::vector<std::string> apart;
    std::size_t line = 0;
    for (std::size_t node = 0; node < reached.size(); ++node)
        if (!reached[node]) {
            line = line == 0 ? graph.nodes[node].line : line;
            apart.push_back(fmt::format("\"{}\"", graph.nodes[node].name));
        }
    constexpr std::size_t most = 8;
    const bool more = apart.size() > most;
    apart.resize(std::min(apart.size(), most));
    if (!apart.empty())
        refuse_graph(file, line,
                     fmt::format("no edges lead from \"{}\" to {}{}", graph.nodes[0].name, fmt::join(apart, ", "),
                                 more ? ", ..." : ""),
                     "add an edge: the processors of a machine must be connected");
}

/// Replaces each node of more than four edges by two processors and a wire between them. The first processor has three
/// edges of the node, the second processor the other edges.
void split_nodes(Graph& graph) {
    constexpr std::size_t edges_of_first = links_of_a_node - 1;
    const auto edges = edges_by_node(graph);
    for (std::size_t node = 0; node < edges.size(); ++node) {
        if (edges[node].size() <= links_of_a_node)
            continue;
        const std::size_t second = graph.nodes.size();
        GraphNode copy = graph.nodes[node];
        copy.name += ", second processor";
        graph.nodes.push_back(std::move(copy));
        for (std::size_t i = edges_of_first; i < edges[node].size(); ++i) {
            GraphEdge& edge = graph.edges[edges[node][i]];
            (edge.from == node ? edge.from : edge.to) = second;
        }
        graph.edges.push_back({node, second, {}, graph.nodes[node].line});
    }
}

/// Returns the number that the text states in the netlist language, where it may end in K or M. Returns nothing if the
/// text is not a number.
std::optional<double> number_in(const std::string& text, bool decimal_suffixes) {
    const double kilo = decimal_suffixes ? 1000 : 1024;
    const double factor = text.ends_with('K') ? kilo : text.ends_with('M') ? kilo * kilo : 1;
    const auto number = parse_number<double>(text.substr(0, text.size() - (factor == 1 ? 0 : 1)));
    return number && std::isfinite(*number) ? std::optional(*number * factor) : std::nullopt;
}

/// Returns the reason why the text is not a value of the attribute. Returns "" if the text is a value of the attribute.
std::string fault_of(const std::string& text, const AttributeDescription& attribute) {
    const auto number = number_in(text, attribute.decimal_suffixes);
    if (!number)
        return "is not a number";
    if (!in_range(attribute.value, *number))
        return "is out of range";
    return attribute.value.type == ParameterType::integer && std::floor(*number) != *number ? "is not an integer" : "";
}

std::string hint_for(const AttributeDescription& attribute) {
    const bool has_range = attribute.value.least || attribute.value.most;
    return has_range ? "expected " + range_of(attribute.value) : "give a number such as 20000000 or 20M";
}

/// Returns the value as the netlist language writes it. REQUIRES: fault_of() finds no fault.
std::string value_text(const std::string& text, const AttributeDescription& attribute) {
    if (parse_number<std::uint64_t>(text.substr(0, text.find_first_of("KM"))))
        return text;
    const double number = number_in(text, attribute.decimal_suffixes).value();
    return std::floor(number) == number ? fmt::format("{:.0f}", number) : fmt::format("{}", number);
}

/// Returns the text in a form that can be written in a comment.
std::string for_comment(std::string text) {
    std::ranges::replace_if(
        text, [](char each) { return each == '*' || each == '/' || static_cast<unsigned char>(each) < ' '; }, '_');
    return text;
}

/// Makes a topology from a graph whose nodes have at most four edges.
class GraphTopology {
public:
    GraphTopology(const Graph& graph, std::shared_ptr<const SourceFile> file, const Catalogue& catalogue)
        : graph_(graph), file_(std::move(file)), catalogue_(catalogue), links_(graph.nodes.size()),
          ports_(graph.nodes.size()) {}

    Topology make(const std::string& path) && {
        const std::string nodes = std::to_string(graph_.nodes.size());
        made_ = {.about = "The graph of " + for_comment(path),
                 .vals = {"val nodes " + nodes + ";"},
                 .array = "[nodes]",
                 .first = "[0]",
                 .at = "[i]",
                 .wires = {},
                 .host = {}};
        made_.nodes = graph_.nodes.size();
        find_type();
        add_nodes();
        add_wires();
        add_host();
        if (!unused_.empty())
            made_.about += fmt::format(" (attributes that have no effect: {})", fmt::join(unused_, ", "));
        return std::move(made_);
    }

private:
    /// Finds the type of the processors. All processors must have the same type, because they are elements of one
    /// array.
    void find_type() {
        std::set<std::string> types;
        for (const GraphNode& node : graph_.nodes) {
            const auto type = node.attributes.find("type");
            if (type != node.attributes.end())
                require_transputer(node, type->second);
            types.insert(type == node.attributes.end() ? made_.type : type->second);
            if (types.size() > 1)
                refuse_graph(file_, node.line,
                             fmt::format("the nodes are of different types: {}", fmt::join(types, ", ")),
                             "give all nodes the same attribute \"type\", or none");
        }
        made_.type = *types.begin();
    }

    void require_transputer(const GraphNode& node, const std::string& type) const {
        const auto found = catalogue_.node_types().find(type);
        if (found != catalogue_.node_types().end()) {
            const NodeType& known = found->second;
            const DeviceKind& kind = *known.preset.kind;
            if (kind.has_executive() && kind.attribute("channelcall") && !known.needs_type &&
                static_cast<std::size_t>(known.links) >= links_of_a_node)
                return;
        }
        refuse_graph(file_, node.line,
                     fmt::format("the node \"{}\" has the type \"{}\", which is not a transputer of four links",
                                 node.name, type),
                     "give a type such as T800 or T414; rename the attribute if it does not state the transputer");
    }

    /// The attributes that have an effect, and what the netlist calls each.
    using Known = std::map<std::string, const AttributeDescription*>;

    std::string entries_of(const GraphAttributes& attributes, const Known& known, const std::string& owner,
                           std::size_t line) {
        std::vector<std::string> entries;
        for (const auto& [name, value] : attributes)
            if (const auto found = known.find(name); found != known.end())
                entries.push_back(entry_of(*found->second, value, name + " of " + owner, line));
            else if (name != "type" && unused_.size() < 20)
                unused_.insert(for_comment(name));
        return entries.empty() ? "" : fmt::format(" ({})", fmt::join(entries, ", "));
    }

    std::string entry_of(const AttributeDescription& attribute, const std::string& value, const std::string& what,
                         std::size_t line) const {
        if (const std::string fault = fault_of(value, attribute); !fault.empty())
            refuse_graph(file_, line, fmt::format("{}: \"{}\" {}", what, value, fault), hint_for(attribute));
        return attribute.value.name + " = " + value_text(value, attribute);
    }

    /// Returns ": label" if the label says more than the node's name. Graphviz writes "\\N" for the name.
    static std::string label_of(const GraphNode& node) {
        const auto label = node.attributes.find("label");
        const bool says_more = label != node.attributes.end() && label->second != node.name && label->second != "\\N";
        return says_more ? ": " + for_comment(label->second) : "";
    }

    void add_nodes() {
        Known known;
        for (const AttributeDescription& each : catalogue_.node_types().at(made_.type).preset.kind->attributes)
            known[each.value.name] = &each;
        for (std::size_t i = 0; i < graph_.nodes.size(); ++i) {
            const GraphNode& node = graph_.nodes[i];
            const std::string entries = entries_of(node.attributes, known, node.name, node.line);
            if (!entries.empty())
                made_.attributes += fmt::format("t[{}]{}; ", i, entries);
            made_.attributes += fmt::format("/* t[{}] is {}{} */\n", i, for_comment(node.name), label_of(node));
        }
    }

    static Known known_of_edges() {
        Known known;
        for (const AttributeDescription& each : connection_attributes())
            if (each.value.name == "linkspeed" || each.value.name == "length")
                known[each.value.name] = &each;
        known["speed"] = known.at("linkspeed");
        return known;
    }

    void add_wires() {
        const Known known = known_of_edges();
        std::string statements;
        std::size_t named = 0;
        for (const GraphEdge& edge : graph_.edges) {
            const std::string owner =
                fmt::format("the edge from {} to {}", graph_.nodes[edge.from].name, graph_.nodes[edge.to].name);
            if (edge.attributes.contains("speed") && edge.attributes.contains("linkspeed"))
                refuse_graph(file_, edge.line, owner + " has both \"speed\" and \"linkspeed\"",
                             "leave one of them out");
            const bool is_first = joined_.insert(std::minmax(edge.from, edge.to)).second;
            Wires wire{.loops = {}, .from = end_at(edge.from, is_first), .to = end_at(edge.to, is_first)};
            if (const std::string entries = entries_of(edge.attributes, known, owner, edge.line); !entries.empty()) {
                wire.name = fmt::format("wire[{}]", named++);
                statements += wire.name + entries + ";\n";
            }
            made_.wires.push_back(std::move(wire));
        }
        if (named > 0)
            made_.attributes += fmt::format("connection wire[{}];\n{}", named, statements);
    }

    /// Allocates the next free link of a node, and its next free port if the wire leads to a new neighbour.
    WireEnd end_at(std::size_t node, bool is_new) {
        return {fmt::format("[{}]", node), std::to_string(links_[node]++),
                is_new ? std::to_string(ports_[node]++) : ""};
    }

    void add_host() {
        const auto free = std::ranges::find_if(links_, [](std::size_t used) { return used < links_of_a_node; });
        if (free == links_.end())
            made_.no_host = "every processor has four neighbours and four links";
        else
            made_.host = {"", "0", fmt::format("[{}]", free - links_.begin()), std::to_string(*free)};
    }

    const Graph& graph_;
    std::shared_ptr<const SourceFile> file_;
    const Catalogue& catalogue_;
    std::vector<std::size_t> links_, ports_; ///< numbers of used links and ports of each node
    std::set<std::pair<std::size_t, std::size_t>> joined_;
    std::set<std::string> unused_;
    Topology made_;
};

} // namespace

bool is_graph_file(const std::string& topology) {
    const std::string ending = ending_of(topology);
    return ending == ".graphml" || ending == ".dot" || ending == ".gv";
}

Topology topology_of_graph(const TopologyRequest& request, const Catalogue& catalogue) {
    if (!request.size.empty() || request.branches || request.chord || request.degree)
        throw UserError(fmt::format("{}: the file states the size and the wires; leave out --size, --branches, --chord "
                                    "and --degree",
                                    request.topology));
    const auto file = load_graph_text(request.topology);
    Graph graph = ending_of(request.topology) == ".graphml" ? read_graphml(file) : read_dot(file);
    if (graph.nodes.empty())
        refuse_graph(file, 0, "the graph has no nodes", "add nodes; each node becomes a processor");
    if (graph.directed)
        join_directions(graph, file);
    require_connected(graph, file);
    if (request.split) {
        require_edges(graph, file, 2 * (links_of_a_node - 1),
                      "a node can have at most six edges: two processors have six links besides the wire between them");
        split_nodes(graph);
    }
    require_edges(graph, file, links_of_a_node,
                  "a transputer has four links; --split builds such nodes from two processors each");
    if (graph.nodes.size() > most_processors)
        refuse_graph(file, 0, fmt::format("the graph has {} nodes", graph.nodes.size()),
                     fmt::format("a generated machine has at most {} processors", most_processors));
    return GraphTopology(graph, file, catalogue).make(request.topology);
}

} // namespace placedpar::generate
