#include "explore/generate/graph.hpp"

#include <pugixml.hpp>

#include <fmt/format.h>

namespace placedpar::generate {

namespace {

/// Returns an XPath for elements of this name, whatever their namespace.
std::string named(std::string_view name) { return fmt::format("*[local-name()='{}']", name); }

/// Reads a graph from the elements of an XML text. Elements are found by XPath, since the parser does not know the
/// namespaces that they may be in.
class GraphmlReader {
public:
    explicit GraphmlReader(const std::shared_ptr<const SourceFile>& file) : file_(file) {
        const pugi::xml_parse_result parsed =
            document_.load_buffer(file_->text().data(), file_->text().size(),
                                  pugi::parse_default | pugi::parse_trim_pcdata, pugi::encoding_utf8);
        if (!parsed)
            refuse_graph(file_, fmt::format("this is not well-formed XML: {}", parsed.description()), "",
                         line_at(static_cast<std::size_t>(parsed.offset)));
    }

    Graph read() {
        const pugi::xml_node graph = document_.select_node(("//" + named("graph")).c_str()).node();
        if (!graph)
            refuse_graph(file_, "the file has no element <graph>", "GraphML as networkx or yEd writes it");
        if (const auto hyperedge = document_.select_node(("//" + named("hyperedge")).c_str()))
            refuse_graph(file_, "the graph has a <hyperedge>", "a wire joins two processors",
                         line_of(hyperedge.node()));
        read_keys();
        GraphBuilder builder(file_, graph.attribute("edgedefault").value() == std::string_view("directed"));
        for (const pugi::xml_node node : all(named("node") + "[not(" + named("graph") + ")]")) // without groups
            builder.add_node(node.attribute("id").value(), attributes_of(node, "node"), line_of(node));
        for (const pugi::xml_node edge : all(named("edge")))
            builder.add_edge(edge.attribute("source").value(), edge.attribute("target").value(),
                             attributes_of(edge, "edge"), line_of(edge));
        return std::move(builder).take();
    }

private:
    struct Key {
        std::string of, name, by_default;
    };

    /// Returns all elements of an XPath in the order of the file.
    std::vector<pugi::xml_node> all(const std::string& path) const {
        pugi::xpath_node_set found = document_.select_nodes(("//" + path).c_str());
        found.sort();
        std::vector<pugi::xml_node> nodes;
        for (const pugi::xpath_node& each : found)
            nodes.push_back(each.node());
        return nodes;
    }

    void read_keys() {
        for (const pugi::xml_node key : all(named("key")))
            if (const std::string name = key.attribute("attr.name").value(); !name.empty())
                keys_[key.attribute("id").value()] = {key.attribute("for").value(), name,
                                                      key.select_node(named("default").c_str()).node().text().get()};
    }

    /// Returns the data of an element, its label in yEd, and the defaults of all other keys.
    GraphAttributes attributes_of(const pugi::xml_node& element, std::string_view kind) const {
        GraphAttributes attributes;
        for (const pugi::xpath_node& data : element.select_nodes(data_))
            if (const auto key = keys_.find(data.node().attribute("key").value());
                key != keys_.end() && !data.node().text().empty())
                attributes[key->second.name] = data.node().text().get();
        if (const auto label = element.select_node(label_))
            attributes["label"] = label.node().value();
        for (const auto& [id, key] : keys_)
            if (!key.by_default.empty() && (key.of == kind || key.of == "all"))
                attributes.emplace(key.name, key.by_default);
        return attributes;
    }

    std::size_t line_of(const pugi::xml_node& element) {
        return line_at(static_cast<std::size_t>(element.offset_debug()));
    }

    /// Returns the line of a place in the text. Counts from the place before, since most calls go forwards.
    std::size_t line_at(std::size_t offset) {
        if (offset < counted_)
            counted_ = 0, line_ = 1;
        for (; counted_ < offset; ++counted_)
            line_ += file_->text()[counted_] == '\n' ? 1U : 0U;
        return line_;
    }

    std::shared_ptr<const SourceFile> file_;
    pugi::xml_document document_;
    std::map<std::string, Key> keys_; ///< with a name, by their id
    pugi::xpath_query data_{named("data").c_str()};
    pugi::xpath_query label_{(named("data") + "//" + named("NodeLabel") + "/text()").c_str()};
    std::size_t counted_ = 0, line_ = 1;
};

} // namespace

Graph read_graphml(const std::shared_ptr<const SourceFile>& file) { return GraphmlReader(file).read(); }

} // namespace placedpar::generate
