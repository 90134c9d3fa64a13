#include "explore/generate/graph.hpp"

#include "text/refused_text.hpp"

#include <fmt/format.h>

#include <utility>

namespace placedpar::generate {

void refuse_graph(const std::shared_ptr<const SourceFile>& file, std::size_t line, const std::string& message,
                  const std::string& hint) {
    Diagnostic fault = error_at(line, line == 0 ? 0 : 1, message, hint);
    fault.location.file = file;
    throw RefusedText({std::move(fault)});
}

std::size_t GraphBuilder::node(const std::string& name, std::size_t line) {
    const auto [found, is_new] = numbers_.emplace(name, graph_.nodes.size());
    if (is_new) {
        require_room(line);
        graph_.nodes.push_back({.name = name, .line = line});
    }
    return found->second;
}

void GraphBuilder::add_edge(GraphEdge edge) {
    require_room(edge.line);
    if (edge.from == edge.to)
        refuse_graph(file_, edge.line,
                     fmt::format("the edge leads from \"{0}\" to \"{0}\"", graph_.nodes[edge.from].name),
                     "remove the edge: a wire joins two different processors");
    graph_.edges.push_back(std::move(edge));
}

void GraphBuilder::count_copy(const GraphAttributes& attributes, std::size_t line) {
    for (const auto& [name, value] : attributes)
        attributes_ += 1 + (name.size() + value.size()) / 100;
    if (attributes_ > most_graph_attributes)
        refuse_graph(file_, line,
                     fmt::format("the defaults give the graph more than {} attributes", most_graph_attributes),
                     "use fewer or shorter defaults; a long attribute counts once for each hundred bytes");
}

void GraphBuilder::require_room(std::size_t line) const {
    if (graph_.nodes.size() + graph_.edges.size() >= most_graph_elements)
        refuse_graph(file_, line, fmt::format("the graph has more than {} nodes and edges", most_graph_elements));
}

} // namespace placedpar::generate
