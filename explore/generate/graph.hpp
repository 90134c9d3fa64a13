#pragma once

#include "text/source.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace placedpar::generate {

using GraphAttributes = std::map<std::string, std::string>;

struct GraphNode {
    std::string name;
    GraphAttributes attributes = {};
};

struct GraphEdge {
    std::size_t from = 0, to = 0; ///< indices of nodes
    GraphAttributes attributes = {};
};

struct Graph {
    bool directed = false;
    std::vector<GraphNode> nodes;
    std::vector<GraphEdge> edges;
};

/// These limits keep hostile input from costing time; a generated machine is smaller.
inline constexpr std::size_t most_graph_elements = 100'000; ///< nodes and edges together
/// With all copies of defaults; an attribute counts once for each hundred bytes that it has.
inline constexpr std::size_t most_graph_attributes = 10 * most_graph_elements;

// These functions read a graph. Throw RefusedText, which shows the file, and the place of the error if it is known.

/// Reads GraphML, as networkx and yEd write it. Data of nodes and edges are attributes. Nodes inside a group count; the
/// group itself does not.
Graph read_graphml(const std::shared_ptr<const SourceFile>&);
/// Reads the language of Graphviz with its library. Attributes of graphs have no effect. Not thread-safe, since the
/// library is not.
Graph read_dot(const std::shared_ptr<const SourceFile>&);

/// Throws RefusedText. `line`: 0 if it is not known.
[[noreturn]] void refuse_graph(const std::shared_ptr<const SourceFile>&, const std::string& message,
                               const std::string& hint = "", std::size_t line = 0);

/// Collects the nodes and edges of a graph while it is read. Throws RefusedText for elements that do not fit, and for a
/// graph that is too large.
class GraphBuilder {
public:
    GraphBuilder(std::shared_ptr<const SourceFile> file, bool directed) : file_(std::move(file)) {
        graph_.directed = directed;
    }

    void add_node(const std::string& name, GraphAttributes, std::size_t line = 0);
    void add_edge(const std::string& from, const std::string& to, GraphAttributes, std::size_t line = 0);
    Graph take() && { return std::move(graph_); }

private:
    std::size_t number_of(const std::string& node, const char* end, std::size_t line) const;
    void count(const GraphAttributes&, std::size_t line);

    std::shared_ptr<const SourceFile> file_;
    Graph graph_;
    std::map<std::string, std::size_t> numbers_; ///< of the nodes
    std::size_t attributes_ = 0;                 ///< counted so far
};

} // namespace placedpar::generate
