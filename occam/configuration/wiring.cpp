#include "netlist/network/names.hpp"
#include "occam/configuration/configuration.hpp"
#include "occam/configuration/configurer.hpp"
#include "text/nearest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <variant>

namespace placedpar::occam {

namespace {

/// Returns the name of a type from a text such as "t800 ". Texts in a table may have blanks at the end.
std::string type_in(const std::vector<std::uint8_t>& bytes) {
    std::string type(bytes.begin(), bytes.end());
    type.erase(type.find_last_not_of(' ') + 1);
    std::ranges::transform(type, type.begin(), [](char c) { return c == 't' ? 'T' : c; });
    return type;
}

} // namespace

std::span<const std::string_view> processor_types() {
    static constexpr std::array<std::string_view, 9> types = {"T805", "T801", "T800", "T425", "T414",
                                                              "T400", "T225", "T222", "T212"};
    return types;
}

const std::vector<NodeAttribute>& node_attributes() {
    static const std::vector<NodeAttribute> attributes = {
        {"type", "type of the processor, such as \"T800\""},
        {"memsize", "size of the memory in bytes, including the memory on the chip"},
        {"root", "whether the processor is the root; read without effect"},
        {"romsize", "size of the ROM in bytes; read without effect"}};
    return attributes;
}

/// Returns an end of a connection. If the end has an error, reports the error, and returns nothing.
std::optional<WireEnd> Configurer::end_of(ConnectionEnd& end) {
    checker_.check(end.path);
    const Type::Kind kind = innermost(*end.path.type).kind;
    if (kind == Type::Kind::node && !end.link) {
        checker_.report(end.path.at, "the link of this node is missing", "write the number of a link: node[link][0]");
        return std::nullopt;
    }
    if (kind == Type::Kind::edge && end.link) {
        checker_.report(end.path.at, "an edge has no links", "write its name alone");
        return std::nullopt;
    }
    const bool is_edge = kind == Type::Kind::edge;
    const auto element = single(end.path, is_edge ? Type::Kind::edge : Type::Kind::node, "a node or an edge");
    const auto link = end.link ? constant(*end.link, "the number of a link") : 0;
    if (!element || !link)
        return std::nullopt;
    const Place link_at = end.link ? end.link->at : end.path.at;
    if (*link < 0 || *link > 3) {
        checker_.report(link_at, fmt::format("link {} does not exist", *link), "a transputer has the links 0 to 3");
        return std::nullopt;
    }
    return WireEnd{.element = *element, .is_edge = is_edge, .link = *link, .at = end.path.at, .link_at = link_at};
}

void Configurer::connect(const Place& place, Connect& written) {
    std::optional<WireEnd> a = end_of(written.from), b = end_of(written.to);
    const auto arc = written.arc ? single(*written.arc, Type::Kind::arc, "an arc") : std::nullopt;
    if (!a || !b)
        return;
    if (a->is_edge && b->is_edge)
        return checker_.report(place, "an edge cannot be connected to an edge", "connect it to a link of a node");
    if (a->is_edge)
        std::swap(a, b);
    if (arc)
        name_wire(*arc, written.arc->at);
    configured_.wires.push_back({*a, *b});
}

/// States that the arc names the wire that is added next. Reports an arc that already names a wire.
void Configurer::name_wire(const Element& arc, const Place& place) {
    const auto [known, is_new] = configured_.wire_of_arc.emplace(arc, configured_.wires.size());
    if (!is_new)
        checker_.report(place, fmt::format("the arc \"{}\" is used twice", text(arc)), "",
                        {{"first used here", at(configured_.wires[known->second].a.at)}});
}

void Configurer::set(SetNode& written) {
    const auto node = single(written.node, Type::Kind::node, "a node");
    for (Setting& each : written.settings) {
        checker_.check(each.value);
        if (!find_named(node_attributes(), each.name))
            checker_.report(each.at,
                            unknown_name("attribute", each.name, names_in(node_attributes()),
                                         "SET has the attributes type and memsize"),
                            "");
        else if (node && each.name == "type")
            set_type(configured_.nodes[*node], *node, each);
        else if (node && each.name == "memsize")
            set_memory(configured_.nodes[*node], *node, each);
    }
}

void Configurer::set_type(NodeState& state, const Element& node, Setting& setting) {
    if (!setting.value.constant || !setting.value.constant->bytes)
        return checker_.report(setting.value.at, "the type of a node must be a string",
                               "write a type such as \"T800\"");
    if (!state.type.empty())
        return checker_.report(setting.at, fmt::format("the type of \"{}\" is set twice", text(node)), "",
                               {{"first set here", at(state.type_at)}});
    const std::string type = type_in(*setting.value.constant->bytes);
    if (std::ranges::find(processor_types(), type) == processor_types().end())
        return checker_.report(setting.value.at, fmt::format("\"{}\" is not a type of processor", type),
                               fmt::format("the types are {}", fmt::join(processor_types(), ", ")));
    state.type = type;
    state.type_at = setting.at;
}

void Configurer::set_memory(NodeState& state, const Element& node, Setting& setting) {
    const auto bytes = constant(setting.value, "the size of a memory");
    if (!bytes)
        return;
    if (state.memory_at.line > 0)
        return checker_.report(setting.at, fmt::format("the memory of \"{}\" is set twice", text(node)), "",
                               {{"first set here", at(state.memory_at)}});
    state.memory_bytes = *bytes;
    state.memory_at = setting.value.at;
}

void Configurer::map(MapOnto& written) {
    checker_.check(written.onto);
    const bool onto_arc = innermost(*written.onto.type).kind == Type::Kind::arc;
    const auto onto = onto_arc ? single(written.onto, Type::Kind::arc, "an arc")
                               : single(written.onto, Type::Kind::node, "a node or an arc");
    const auto priority = written.priority ? constant(*written.priority, "the priority") : 1;
    if (priority && (*priority < 0 || *priority > 1))
        checker_.report(written.priority->at, fmt::format("priority {} does not exist", *priority),
                        "HIGH is 0, LOW is 1");
    for (Expression& each : written.mapped) {
        const auto mapped =
            onto_arc ? elements(each, Type::Kind::channel, "a channel") : elements(each, Type::Kind::node, "a node");
        for (const Element& element : mapped)
            if (onto && onto_arc)
                place_on_arc(element, each.at, *onto);
            else if (onto && priority)
                map_node(element, each.at, *onto, *priority == 0);
    }
}

void Configurer::map_node(const Element& node, const Place& place, const Element& onto, bool high_priority) {
    NodeState& state = configured_.nodes[node];
    if (state.onto)
        return checker_.report(place, fmt::format("\"{}\" is mapped twice", text(node)), "",
                               {{"first mapped here", at(state.onto_at)}});
    state.onto = onto;
    state.onto_at = place;
    state.high_priority = high_priority;
}

void Configurer::place_on_arc(const Element& channel, const Place& place, const Element& arc) {
    ChannelState& state = configured_.channels[channel];
    if (state.placed_at.line > 0)
        return checker_.report(place, fmt::format("the channel \"{}\" is placed twice", text(channel)), "",
                               {{"first placed here", at(state.placed_at)}});
    state.arc = arc;
    state.placed_at = place;
}

/// Executes `PLACE c, d ON arc:` and `PLACE c AT 2:`.
void Configurer::place(Declaration& declaration, Placement& placement) {
    if (placement.where == Placement::Where::arc) {
        const auto arc = single(*placement.address, Type::Kind::arc, "an arc");
        for (Expression& path : placement.paths)
            for (const Element& channel : elements(path, Type::Kind::channel, "a channel"))
                if (arc)
                    place_on_arc(channel, path.at, *arc);
        return;
    }
    if (placement.where != Placement::Where::address)
        return checker_.report(declaration.at, "a configuration can place only channels",
                               "write ON and an arc, or AT and a link");
    const auto word = constant(*placement.address, "the address");
    if (!here_)
        return checker_.report(declaration.at, "a channel can be placed at a link only below a PROCESSOR",
                               "write this line below PROCESSOR, in front of its process");
    for (Expression& path : placement.paths)
        if (word)
            place_at_link(path, *word, placement.address->at);
}

/// Places a channel at a link of the present processor: words 0 to 3 are the outputs of the links, 4 to 7 the inputs.
void Configurer::place_at_link(Expression& path, std::int64_t word, const Place& word_at) {
    const auto channel = single(path, Type::Kind::channel, "a channel");
    if (!channel)
        return;
    if (word < 0 || word > 7)
        return checker_.report(word_at, fmt::format("the address {} does not belong to a link", word),
                               "the addresses 0 to 3 are the outputs of the links, 4 to 7 their inputs");
    ChannelState& state = configured_.channels[*channel];
    std::optional<WireEnd>& end = word < 4 ? state.leaves : state.arrives;
    if (end)
        return checker_.report(
            path.at,
            fmt::format("the channel \"{}\" is placed at two {}", text(*channel), word < 4 ? "outputs" : "inputs"), "",
            {{"first placed here", at(end->at)}});
    end = WireEnd{.element = here_->node, .link = word % 4, .at = path.at, .link_at = word_at};
}

} // namespace placedpar::occam
