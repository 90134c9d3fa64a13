#include "editor/language/navigation.hpp"

#include "editor/language/netlist_context.hpp"
#include "netlist/language/parser.hpp"
#include "report/kinds_report.hpp"
#include "text/load_source.hpp"
#include "text/texts_in_memory.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar::editor {

namespace {

using Place = NetlistContext::Place;

/// Returns a line of a file without the blanks around it.
std::string trimmed_line(const Location& at) {
    const std::string_view line = at.file->line(at.line);
    const auto first = line.find_first_not_of(" \t");
    return first == std::string_view::npos ? "" : std::string(line.substr(first));
}

std::string port_text(const PortDescription& port) {
    return fmt::format("{} {}: {}\n{}{}\n", word(port.direction), port.name, port.protocol, port.about,
                       port.optional ? " (may stay unconnected)" : "");
}

std::string member_text(const NetlistOwner& owner, const std::string& member) {
    if (const PortDescription* port = owner.kind ? owner.kind->port(member) : nullptr)
        return port_text(*port);
    if (const ParameterDescription* parameter = owner.kind ? owner.kind->parameter(member) : nullptr)
        return print_parameter(*parameter, parameter->default_value);
    if (owner.device && owner.links > 0 && member == "link")
        return fmt::format("link[0] to link[{}] of {}\n", owner.links - 1, owner.device->noun);
    return "";
}

std::string attribute_text(const NetlistSyntax& syntax, const Catalogue& catalogue, const NetlistContext& context,
                           const std::string& name) {
    for (const ParameterDescription& each : attributes_in(syntax, catalogue, context))
        if (each.name == name)
            return print_parameter(each, each.default_value);
    return "";
}

std::string fault_text(const NetlistOwner& owner, const std::string& name) {
    for (const FaultKind& each : faults_of(owner))
        if (each.name == name)
            return fmt::format("{}\n{}\n", each.name, each.about);
    return "";
}

std::string kind_text(const Catalogue& catalogue, const std::string& name) {
    const bool is_known = catalogue.find(name) || catalogue.node_types().contains(name);
    return is_known ? print_kind(catalogue, name) : "";
}

std::string name_text(const NetlistName& name) {
    const std::string program = name.program.empty() ? "" : fmt::format("executes {}\n", name.program);
    return fmt::format("{}\n{}declared in {}, line {}\n", trimmed_line(name.at), program, name.at.file->path(),
                       name.at.line);
}

/// Returns the beginning of the file of this name, if the file is beside the netlist or the netlist includes it;
/// otherwise nothing.
std::optional<Location> named_file(const NetlistSyntax& syntax, const std::string& name) {
    const std::filesystem::path beside = std::filesystem::path(syntax.file->path()).parent_path() / name;
    std::optional<std::filesystem::path> path;
    if (names_file(beside))
        path = beside;
    for (const std::string& each : syntax.included)
        if (!path && std::filesystem::path(each).filename() == std::filesystem::path(name).filename())
            path = each;
    return path ? std::optional(Location{load_source(*path).file, 1, 1}) : std::nullopt;
}

} // namespace

std::string hover_netlist(const NetlistSyntax& syntax, const Catalogue& catalogue, const Location& at) {
    const auto index = token_at(syntax.tokens, at);
    if (!index)
        return "";
    const Token& token = syntax.tokens[*index];
    if (token.kind == TokenKind::text)
        return kind_text(catalogue, token.text);
    if (token.kind != TokenKind::name)
        return "";
    const NetlistContext context = context_of(syntax.tokens, *index);
    if (context.place == Place::member)
        return member_text(owner_of(syntax, catalogue, context.owner), token.text);
    if (context.place == Place::attribute)
        return attribute_text(syntax, catalogue, context, token.text);
    if (context.place == Place::fault)
        return fault_text(owner_of(syntax, catalogue, context.owner), token.text);
    if (const NetlistName* name = syntax.name_at(token.at))
        return name_text(*name);
    return kind_text(catalogue, token.text);
}

std::optional<Location> definition_in_netlist(const NetlistSyntax& syntax, const Location& at) {
    const auto index = token_at(syntax.tokens, at);
    if (!index)
        return std::nullopt;
    const Token& token = syntax.tokens[*index];
    if (token.kind == TokenKind::text)
        return named_file(syntax, token.text.substr(0, token.text.find('#')));
    const NetlistName* name = syntax.name_at(token.at);
    return token.kind == TokenKind::name && name ? std::optional(name->at) : std::nullopt;
}

std::vector<Location> places_to_rename(const NetlistSyntax& syntax, const Catalogue& catalogue, const Location& at,
                                       const std::string& new_name) {
    const NetlistName* const name = syntax.name_at(at);
    if (!name)
        throw UserError("the word at this place cannot be renamed: only names that the netlist declares can be, not "
                        "ports, parameters or kinds");
    if (has_errors(syntax.diagnostics))
        throw UserError("the netlist has errors; correct the errors first, so that all places of the name are found");
    if (!can_be_a_name(new_name))
        throw UserError(fmt::format(
            "\"{}\" cannot be a name: a name consists of letters, digits and _, and is not a word of the language",
            new_name));
    if (syntax.find(new_name))
        throw UserError(fmt::format("\"{}\" is declared already", new_name));
    if (new_name == "host" || catalogue.node_types().contains(new_name))
        throw UserError(fmt::format("\"{}\" is predefined", new_name));
    std::vector<Location> places;
    for (const NetlistNameUse& each : syntax.uses)
        if (syntax.names[each.name].name == name->name && &syntax.names[each.name] == name)
            places.push_back(each.at);
    for (const Location& each : places)
        if (each.file != syntax.file)
            throw UserError(fmt::format("\"{}\" is also used in {}, line {}: first rename it there by hand", name->name,
                                        each.file->path(), each.line));
    return places;
}

std::vector<OutlineEntry> outline_of(const NetlistSyntax& syntax) {
    std::vector<OutlineEntry> entries;
    for (const NetlistName& each : syntax.names)
        if (each.at.file == syntax.file && each.category != NetlistName::Category::replicator)
            entries.push_back({each.name, each.program.empty() ? each.type : each.program, each.at});
    return entries;
}

} // namespace placedpar::editor
