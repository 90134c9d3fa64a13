#include "explore/generate/graph.hpp"
#include "explore/generate/xml.hpp"

#include <fmt/format.h>

#include <utility>

namespace placedpar::generate {

namespace {

std::string trimmed_text(const std::string& text) {
    constexpr const char* blank = " \t\r\n";
    const std::size_t first = text.find_first_not_of(blank);
    return first == text.npos ? "" : text.substr(first, text.find_last_not_of(blank) + 1 - first);
}

class GraphmlReader : XmlParts {
public:
    explicit GraphmlReader(const std::shared_ptr<const SourceFile>& file) : file_(file), builder_(file) {}

    Graph read() {
        read_xml(file_, *this);
        if (!has_graph_)
            refuse_graph(file_, 0, "the file has no element <graph>", "expected GraphML as networkx or yEd writes it");
        const GraphAttributes of_edges = defaults_of("edge"), of_nodes = defaults_of("node");
        for (Element& edge : edges_) {
            add_defaults(edge.attributes, of_edges, edge.line);
            add_edge(edge);
        }
        for (GraphNode& node : builder_.graph().nodes)
            add_defaults(node.attributes, of_nodes, node.line);
        return std::move(builder_.graph());
    }

private:
    /// An element <node> or <edge>.
    struct Element {
        std::map<std::string, std::string> stated; ///< attributes in its tag
        std::size_t line = 0;
        GraphAttributes attributes = {};
        bool is_group = false; ///< a node with a graph inside
    };
    struct Key {
        std::string of, name, by_default;
    };

    void text(std::string_view text) override {
        if (!inside_.empty())
            text_ += text;
    }

    /// Stores the text of a label, which may have elements after the text.
    void note_label() {
        if (!inside_.empty() && inside_.back() == "NodeLabel" && !open_.empty() && !trimmed_text(text_).empty())
            open_.back().attributes["label"] = trimmed_text(text_);
        text_.clear();
    }

    void begin(const XmlTag& tag) override {
        note_label();
        inside_.push_back(tag.name);
        if (tag.name == "key")
            begin_key(tag);
        else if (tag.name == "graph")
            begin_graph(tag);
        else if (tag.name == "hyperedge")
            refuse_graph(file_, tag.line, "the graph has a <hyperedge>",
                         "replace it by edges; a wire joins two processors");
        else if (tag.name == "node" || tag.name == "edge")
            open_.push_back({tag.attributes, tag.line});
        else if (tag.name == "data")
            data_key_ = stated(tag, "key");
    }

    void begin_key(const XmlTag& tag) {
        key_ = &keys_[stated(tag, "id")];
        *key_ = {stated(tag, "for"), stated(tag, "attr.name"), ""};
    }

    void begin_graph(const XmlTag& tag) {
        if (!std::exchange(has_graph_, true))
            builder_.graph().directed = stated(tag, "edgedefault") == "directed";
        if (!open_.empty())
            open_.back().is_group = true;
    }

    static std::string stated(const XmlTag& tag, const std::string& name) {
        const auto found = tag.attributes.find(name);
        return found == tag.attributes.end() ? "" : found->second;
    }

    void end(const std::string& name) override {
        if (name == "default" && key_)
            key_->by_default = trimmed_text(text_);
        else if (name == "data" && !open_.empty())
            add_data();
        else if (name == "node" || name == "edge")
            end_element(name);
        note_label();
        inside_.pop_back();
    }

    void add_data() {
        const auto key = keys_.find(data_key_);
        if (key != keys_.end() && !key->second.name.empty() && !trimmed_text(text_).empty())
            open_.back().attributes[key->second.name] = trimmed_text(text_);
    }

    void end_element(const std::string& name) {
        Element element = std::move(open_.back());
        open_.pop_back();
        if (name == "edge") {
            edges_.push_back(std::move(element));
        } else if (!element.is_group) {
            const std::string id = element.stated["id"];
            if (id.empty() || builder_.has(id))
                refuse_graph(file_, element.line,
                             id.empty() ? "a node has no id" : fmt::format("the node \"{}\" is listed twice", id));
            builder_.graph().nodes.at(builder_.node(id, element.line)).attributes = std::move(element.attributes);
        }
    }

    void add_edge(Element& edge) {
        for (const char* end : {"source", "target"})
            if (!builder_.has(edge.stated[end]))
                refuse_graph(file_, edge.line,
                             fmt::format("the edge's {} \"{}\" is not a node", end, edge.stated[end]));
        builder_.add_edge({builder_.node(edge.stated["source"], edge.line),
                           builder_.node(edge.stated["target"], edge.line), std::move(edge.attributes), edge.line});
    }

    GraphAttributes defaults_of(const std::string& of) const {
        GraphAttributes defaults;
        for (const auto& [id, key] : keys_)
            if (!key.by_default.empty() && !key.name.empty() && (key.of == of || key.of == "all"))
                defaults.emplace(key.name, key.by_default);
        return defaults;
    }

    /// Adds the defaults for attributes that the element does not state.
    void add_defaults(GraphAttributes& attributes, const GraphAttributes& defaults, std::size_t line) {
        builder_.count_copy(defaults, line);
        attributes.insert(defaults.begin(), defaults.end());
    }

    std::shared_ptr<const SourceFile> file_;
    GraphBuilder builder_;
    std::map<std::string, Key> keys_;
    Key* key_ = nullptr; ///< the <key> read last
    std::vector<std::string> inside_;
    std::vector<Element> open_, edges_;
    std::string text_, data_key_;
    bool has_graph_ = false;
};

} // namespace

Graph read_graphml(const std::shared_ptr<const SourceFile>& file) { return GraphmlReader(file).read(); }

} // namespace placedpar::generate
