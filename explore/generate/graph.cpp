#include "explore/generate/graph.hpp"

#include "text/refused_text.hpp"

#include <fmt/format.h>

namespace placedpar::generate {

void refuse_graph(const std::shared_ptr<const SourceFile>& file, const std::string& message, const std::string& hint,
                  std::size_t line) {
    Diagnostic fault = error_at(line, line == 0 ? 0 : 1, message, hint);
    fault.location.file = file;
    throw RefusedText({std::move(fault)});
}

void GraphBuilder::add_node(const std::string& name, GraphAttributes attributes, std::size_t line) {
    if (name.empty())
        refuse_graph(file_, "a node has no id", "", line);
    if (!numbers_.emplace(name, graph_.nodes.size()).second)
        refuse_graph(file_, fmt::format("the node \"{}\" is listed twice", name), "", line);
    count(attributes, line);
    graph_.nodes.push_back({name, std::move(attributes)});
}

void GraphBuilder::add_edge(const std::string& from, const std::string& to, GraphAttributes attributes,
                            std::size_t line) {
    const std::size_t source = number_of(from, "source", line), target = number_of(to, "target", line);
    if (source == target)
        refuse_graph(file_, fmt::format("the edge leads from \"{0}\" to \"{0}\"", from), "a wire joins two processors",
                     line);
    count(attributes, line);
    graph_.edges.push_back({source, target, std::move(attributes)});
}

std::size_t GraphBuilder::number_of(const std::string& node, const char* end, std::size_t line) const {
    const auto found = numbers_.find(node);
    if (found == numbers_.end())
        refuse_graph(file_, fmt::format("the edge's {} \"{}\" is not a node", end, node), "", line);
    return found->second;
}

void GraphBuilder::count(const GraphAttributes& attributes, std::size_t line) {
    if (graph_.nodes.size() + graph_.edges.size() >= most_graph_elements)
        refuse_graph(file_, fmt::format("the graph has more than {} nodes and edges", most_graph_elements), "", line);
    for (const auto& [name, value] : attributes)
        attributes_ += 1 + (name.size() + value.size()) / 100;
    if (attributes_ > most_graph_attributes)
        refuse_graph(file_,
                     fmt::format("the graph has more than {} attributes, with its defaults", most_graph_attributes),
                     "a long attribute counts once for each hundred bytes", line);
}

} // namespace placedpar::generate
