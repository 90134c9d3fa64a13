#include "explore/generate/graph.hpp"

#include <boost/property_tree/xml_parser.hpp>
#include <fmt/format.h>

#include <sstream>
#include <utility>

namespace placedpar::generate {

namespace {

using Tree = boost::property_tree::ptree;

/// Moves `at` behind `end`; to the end of the text if it is not there.
void skip_to(std::string_view text, std::size_t& at, std::string_view end) {
    const std::size_t found = text.find(end, at);
    at = found == text.npos ? text.size() : found + end.size();
}

/// Moves `at` behind a tag, which may have ">" in quotes. Returns whether the tag also ends its element.
bool skip_tag(std::string_view text, std::size_t& at) {
    char quote = '\0';
    for (; at < text.size() && (quote != '\0' || text[at] != '>'); ++at)
        if (text[at] == '"' || text[at] == '\'')
            quote = quote == '\0' ? text[at] : quote == text[at] ? '\0' : quote;
    return text[at - 1] == '/';
}

/// Refuses a text that would make the parser, which calls itself for each element, run out of stack.
void require_harmless(const std::shared_ptr<const SourceFile>& file) {
    const std::string_view text = file->text();
    std::size_t depth = 0;
    for (std::size_t at = text.find('<'); at < text.size(); at = text.find('<', at)) {
        const std::string_view left = text.substr(at);
        if (left.starts_with("<!DOCTYPE") && left.substr(0, left.find('>')).find('[') != left.npos)
            refuse_graph(file, 0, "the document type declares entities or elements",
                         "a graph in GraphML needs no declarations");
        if (left.starts_with("<!--"))
            skip_to(text, at, "-->");
        else if (left.starts_with("<![CDATA["))
            skip_to(text, at, "]]>");
        else if (left.starts_with("<?"))
            skip_to(text, at, "?>");
        else if (left.starts_with("<!") || left.starts_with("</"))
            skip_to(text, at, ">");
        else
            depth += skip_tag(text, ++at) ? 0U : 1U;
        if (left.starts_with("</") && depth > 0)
            --depth;
        if (depth > deepest_graph)
            refuse_graph(file, 0, fmt::format("the elements are nested deeper than {} levels", deepest_graph));
    }
}

Tree tree_of(const std::shared_ptr<const SourceFile>& file) {
    require_harmless(file);
    Tree tree;
    std::istringstream in(file->text());
    try {
        read_xml(in, tree, boost::property_tree::xml_parser::trim_whitespace);
    } catch (const boost::property_tree::xml_parser_error& error) {
        refuse_graph(file, error.line(), "the file is not XML: " + error.message(),
                     "GraphML as networkx or yEd writes it");
    }
    return tree;
}

/// Returns an attribute in the tag of an element; "" if it is not there.
std::string stated(const Tree& element, const std::string& name) {
    const auto attributes = element.find("<xmlattr>");
    if (attributes == element.not_found())
        return "";
    const auto found = attributes->second.find(name);
    return found == attributes->second.not_found() ? "" : found->second.data();
}

/// Returns the text of the first label that yEd draws at a node; "" if there is none.
std::string label_in(const Tree& element) {
    for (const auto& [name, child] : element) {
        const std::string label = name.ends_with(":NodeLabel") ? child.data() : label_in(child);
        if (!label.empty())
            return label;
    }
    return "";
}

class GraphmlReader {
public:
    explicit GraphmlReader(const std::shared_ptr<const SourceFile>& file) : file_(file), builder_(file) {}

    Graph read() {
        const Tree document = tree_of(file_), none;
        const Tree& top = document.get_child("graphml", none);
        for (const auto& [name, child] : top)
            if (name == "key")
                keys_[stated(child, "id")] = {stated(child, "for"), stated(child, "attr.name"),
                                              child.get("default", "")};
        if (top.count("graph") == 0)
            refuse_graph(file_, 0, "the file has no element <graph>", "GraphML as networkx or yEd writes it");
        const Tree& graph = top.get_child("graph");
        builder_.graph().directed = stated(graph, "edgedefault") == "directed";
        read_nodes(graph);
        read_edges(graph);
        return std::move(builder_.graph());
    }

private:
    struct Key {
        std::string of, name, by_default;
    };

    /// Reads nodes; in place of a group, reads the nodes inside it.
    void read_nodes(const Tree& graph) {
        for (const auto& [name, child] : graph) {
            if (name == "hyperedge")
                refuse_graph(file_, 0, "the graph has a <hyperedge>", "a wire joins two processors");
            if (name != "node")
                continue;
            if (child.count("graph") > 0) {
                read_nodes(child.get_child("graph"));
                continue;
            }
            const std::string id = stated(child, "id");
            if (id.empty() || builder_.has(id))
                refuse_graph(file_, 0,
                             id.empty() ? "a node has no id" : fmt::format("the node \"{}\" is listed twice", id));
            GraphAttributes attributes = data_of(child, "node");
            if (std::string label = label_in(child); !label.empty())
                attributes["label"] = std::move(label);
            builder_.graph().nodes.at(builder_.node(id, 0)).attributes = std::move(attributes);
        }
    }

    void read_edges(const Tree& graph) {
        for (const auto& [name, child] : graph)
            if (name == "edge")
                builder_.add_edge({end_of(child, "source"), end_of(child, "target"), data_of(child, "edge")});
            else if (name == "node" && child.count("graph") > 0)
                read_edges(child.get_child("graph"));
    }

    std::size_t end_of(const Tree& edge, const char* end) {
        const std::string node = stated(edge, end);
        if (!builder_.has(node))
            refuse_graph(file_, 0, fmt::format("the edge's {} \"{}\" is not a node", end, node));
        return builder_.node(node, 0);
    }

    /// Returns the data of a node or an edge, with defaults.
    GraphAttributes data_of(const Tree& element, const std::string& of) const {
        GraphAttributes attributes;
        for (const auto& [name, child] : element)
            if (const auto key = keys_.find(stated(child, "key"));
                name == "data" && key != keys_.end() && !child.data().empty())
                attributes[key->second.name] = child.data();
        for (const auto& [id, key] : keys_)
            if (!key.by_default.empty() && (key.of == of || key.of == "all"))
                attributes.emplace(key.name, key.by_default);
        attributes.erase(""); // data that only yEd uses
        return attributes;
    }

    std::shared_ptr<const SourceFile> file_;
    GraphBuilder builder_;
    std::map<std::string, Key> keys_;
};

} // namespace

Graph read_graphml(const std::shared_ptr<const SourceFile>& file) { return GraphmlReader(file).read(); }

} // namespace placedpar::generate
