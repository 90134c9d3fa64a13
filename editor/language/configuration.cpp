#include "occam/configuration/configuration.hpp"

#include "editor/language/completion.hpp"
#include "editor/language/navigation.hpp"
#include "editor/language/occam_names.hpp"
#include "netlist/network/names.hpp"
#include "occam/check/checker.hpp"
#include "occam/language/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace placedpar::editor {

namespace {

using occam::Configured;
using occam::Element;

constexpr std::size_t most_elements_shown = 8;

std::string text_of_end(const Configured& configured, const occam::WireEnd& end) {
    const std::string name = occam::text_of(configured, end.element);
    return end.is_edge ? name : fmt::format("{} link {}", name, end.link);
}

/// Returns a text that tells where the wires of a node or an edge lead.
std::string text_of_wires(const Configured& configured, const Element& element) {
    std::vector<std::string> texts;
    for (const occam::WrittenWire& wire : configured.wires)
        for (const auto& [near, far] : {std::pair(wire.a, wire.b), std::pair(wire.b, wire.a)})
            if (near.element == element)
                texts.push_back((near.is_edge ? "" : fmt::format("link {} to ", near.link)) +
                                text_of_end(configured, far));
    return fmt::format("{}", fmt::join(texts, ", "));
}

std::string text_of_node(const Configured& configured, const Element& element) {
    const auto found = configured.nodes.find(element);
    const occam::NodeState state = found == configured.nodes.end() ? occam::NodeState{} : found->second;
    if (state.onto)
        return fmt::format("mapped onto {}{}", text_of(configured, *state.onto),
                           state.high_priority ? " at high priority" : "");
    const std::string wires = text_of_wires(configured, element);
    return (state.type.empty() ? "no type" : fmt::format("{} with {} bytes", state.type, state.memory_bytes)) +
           (wires.empty() ? "" : "; " + wires);
}

std::string text_of_arc(const Configured& configured, const Element& element) {
    const auto found = configured.wire_of_arc.find(element);
    if (found == configured.wire_of_arc.end())
        return "no connection uses it";
    std::vector<std::string> carried;
    for (const Element& each : configured.channel_order)
        if (configured.channels.at(each).arc == element)
            carried.push_back(text_of(configured, each));
    const occam::WrittenWire& wire = configured.wires[found->second];
    return fmt::format("from {} to {}{}{}", text_of_end(configured, wire.a), text_of_end(configured, wire.b),
                       carried.empty() ? "" : "; carries ", fmt::join(carried, ", "));
}

std::string text_of_element(const Configured& configured, const Element& element, occam::Type::Kind kind) {
    using Kind = occam::Type::Kind;
    return kind == Kind::node   ? text_of_node(configured, element)
           : kind == Kind::arc  ? text_of_arc(configured, element)
           : kind == Kind::edge ? "joined to " + text_of_wires(configured, element)
                                : "";
}

/// Returns a line for each element of a node, arc or edge; "" for any other object.
std::string text_of_object(const Configured& configured, std::size_t object) {
    const occam::Type& type = *configured.objects[object].type;
    const std::size_t count = occam::count_of_elements(type);
    std::string text;
    for (std::size_t i = 0; i < std::min(count, most_elements_shown); ++i) {
        const std::string about = text_of_element(configured, {object, i}, occam::innermost(type).kind);
        if (!about.empty())
            text += (count == 1 ? "" : occam::text_of(configured, {object, i}) + ": ") + about + "\n";
    }
    return text.empty() || count <= most_elements_shown
               ? text
               : text + fmt::format("and {} more\n", count - most_elements_shown);
}

/// Returns the text of a line before a column, without the blanks at its beginning.
std::string_view line_before(const SourceFile& file, const Location& at) {
    const std::string_view line = file.line(at.line).substr(0, at.column - 1);
    return line.substr(std::min(line.find_first_not_of(' '), line.size()));
}

/// Returns the types of the names that can follow a word; empty if other words can follow, too.
std::vector<std::string_view> types_after(std::string_view before) {
    const std::size_t end = before.find_last_of(' '), last = before.find_last_not_of(' ', end);
    if (end == before.npos || last == before.npos || before.find('[', end) != before.npos)
        return {};
    const std::size_t blank = before.find_last_of(' ', last), first = blank == before.npos ? 0 : blank + 1;
    const std::string_view word = before.substr(first, last + 1 - first);
    return word == "CONNECT" || word == "TO"      ? std::vector<std::string_view>{"NODE", "EDGE"}
           : word == "WITH" || word == "ON"       ? std::vector<std::string_view>{"ARC"}
           : word == "SET" || word == "PROCESSOR" ? std::vector<std::string_view>{"NODE"}
           : word == "ONTO"                       ? std::vector<std::string_view>{"NODE", "ARC"}
                                                  : std::vector<std::string_view>{};
}

std::vector<Completion> attributes_or_types(std::string_view before) {
    std::vector<Completion> found;
    if (before.find(":=") == before.npos)
        for (const occam::NodeAttribute& each : occam::node_attributes())
            found.push_back({each.name, Completion::Kind::parameter, "attribute", each.about});
    else if (std::ranges::count(before, '"') % 2 != 0)
        for (const std::string_view each : occam::processor_types())
            found.push_back({std::string(each), Completion::Kind::value});
    return found;
}

} // namespace

std::string hover_configuration(const occam::Program& program, const Configured& configured, const Location& at) {
    const std::string name = name_at(*at.file, at).first;
    const occam::Declaration* const meaning = meaning_at(program, at);
    const occam::NodeAttribute* const attribute = find_named(occam::node_attributes(), name);
    if (!meaning)
        return attribute && line_before(*at.file, at).starts_with("SET ")
                   ? fmt::format("{}: {}\n", name, attribute->about)
                   : "";
    std::string text = hover_occam(program, at);
    for (std::size_t i = 0; i < configured.objects.size(); ++i)
        if (configured.objects[i].at == meaning->at && configured.objects[i].name == name)
            text += text_of_object(configured, i);
    return text;
}

std::vector<Completion> complete_configuration(const SourceFile& file, const occam::Program* parsed,
                                               const Location& at) {
    const std::string_view before = line_before(file, at);
    if (before.starts_with("SET ") && before.find('(') != before.npos)
        if (std::vector<Completion> found = attributes_or_types(before); !found.empty())
            return found;
    std::vector<Completion> found = complete_occam(file, parsed, at);
    const std::vector<std::string_view> types = types_after(before);
    if (!types.empty())
        std::erase_if(found, [&](const Completion& each) {
            return std::ranges::none_of(types, [&](auto type) { return each.detail.ends_with(type); });
        });
    else if (!found.empty() && !before.starts_with('#'))
        for (const std::string_view each : occam::configuration_words())
            found.push_back({std::string(each), Completion::Kind::keyword});
    return found;
}

} // namespace placedpar::editor
