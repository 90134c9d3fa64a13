#pragma once

#include "text/source.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace placedpar::generate {

using GraphAttributes = std::map<std::string, std::string>;

struct GraphNode {
    std::string name;
    GraphAttributes attributes = {};
    std::size_t line = 0; ///< line of the file, counted from 1
};

struct GraphEdge {
    std::size_t from = 0, to = 0; ///< indices of nodes
    GraphAttributes attributes = {};
    std::size_t line = 0;
};

struct Graph {
    bool directed = false;
    std::vector<GraphNode> nodes;
    std::vector<GraphEdge> edges;
};

/// These limits bound the time and memory that hostile input can take.
inline constexpr std::size_t most_graph_elements = 100'000; ///< nodes and edges together
inline constexpr std::size_t deepest_graph = 64;            ///< how deeply elements, brackets or subgraphs may be
                                                            ///< nested
/// The largest number of attributes, including copies of default attributes. A long attribute counts as one for each
/// hundred bytes.
inline constexpr std::size_t most_graph_attributes = 10 * most_graph_elements;

// These functions read the graph of a machine: nodes are processors, edges are wires. They throw RefusedText, which
// shows the place of the error.

/// Reads GraphML, as networkx and yEd write it. Data of nodes and edges become attributes. Nodes inside a group become
/// nodes of the graph; the group is ignored.
Graph read_graphml(const std::shared_ptr<const SourceFile>&);
/// Reads a graph in DOT, the language of Graphviz. Ports, and attributes of whole graphs, are ignored.
Graph read_dot(const std::shared_ptr<const SourceFile>&);

/// Throws RefusedText with this message and hint for a line of the file; line 0 stands for the whole file.
[[noreturn]] void refuse_graph(const std::shared_ptr<const SourceFile>&, std::size_t line, const std::string& message,
                               const std::string& hint = "");

/// Collects the nodes and edges of a graph while it is read.
class GraphBuilder {
public:
    explicit GraphBuilder(std::shared_ptr<const SourceFile> file) : file_(std::move(file)) {}

    /// Returns the node's index; adds the node if it is new.
    std::size_t node(const std::string& name, std::size_t line);
    bool has(const std::string& name) const { return numbers_.contains(name); }
    void add_edge(GraphEdge);
    /// Counts attributes that are about to be copied. Throws RefusedText if the graph would have more than
    /// most_graph_attributes.
    void count_copy(const GraphAttributes&, std::size_t line);
    Graph& graph() { return graph_; }

private:
    void require_room(std::size_t line) const;

    std::shared_ptr<const SourceFile> file_;
    Graph graph_;
    std::map<std::string, std::size_t> numbers_;
    std::size_t attributes_ = 0; ///< number of attributes so far
};

} // namespace placedpar::generate
