#include "editor/language/netlist_context.hpp"

#include "netlist/elaborate/attributes.hpp"
#include "netlist/kinds/description.hpp"
#include "netlist/kinds/fault_kinds.hpp"
#include "netlist/language/parser.hpp"

#include <algorithm>
#include <array>
#include <iterator>

namespace placedpar::editor {

namespace {

using Place = NetlistContext::Place;
using Tokens = std::vector<Token>;

/// Returns the index of the first token of the statement that a token belongs to.
std::size_t statement_start(const Tokens& tokens, std::size_t index) {
    int open = 0; // number of `}` passed on the way back whose `{` has not been reached
    for (; index > 0; --index) {
        const Token& before = tokens[index - 1];
        if (before.is(";") && open == 0)
            return index;
        if (before.is("}") && (index < 2 || tokens[index - 2].is(";") || tokens[index - 2].is("}")))
            return index;
        open += before.is("}") ? 1 : 0;
        if (before.is("{") && open-- == 0)
            return index;
        if (before.kind == TokenKind::text && index > 1 && tokens[index - 2].kind == TokenKind::directive)
            return index;
    }
    return 0;
}

/// Returns the index of the opening bracket that matches a closing bracket; `first` if there is none.
std::size_t opening(const Tokens& tokens, std::size_t closing, std::size_t first) {
    const bool square = tokens[closing].is("]");
    int depth = 0;
    for (std::size_t i = closing + 1; i-- > first;) {
        depth += tokens[i].is(square ? "]" : ")") ? 1 : 0;
        if (tokens[i].is(square ? "[" : "(") && --depth == 0)
            return i;
    }
    return first;
}

/// Returns the name of the reference that ends before a token, such as "t" before the dot in `t[i + 1].link`.
std::string name_before(const Tokens& tokens, std::size_t index, std::size_t first) {
    while (index > first && tokens[index - 1].is("]"))
        index = opening(tokens, index - 1, first);
    return index > first && tokens[index - 1].kind == TokenKind::name ? tokens[index - 1].text : "";
}

/// Returns the innermost parenthesis that is open at a token of the statement; nothing if none is open.
std::optional<std::size_t> open_parenthesis(const Tokens& tokens, std::size_t index, std::size_t first) {
    int depth = 0;
    for (std::size_t i = index; i-- > first;) {
        depth += tokens[i].is(")") ? 1 : 0;
        if (tokens[i].is("(") && depth-- == 0)
            return i;
    }
    return std::nullopt;
}

/// Describes a place in the parentheses of a declaration, a setting or a fault.
NetlistContext in_attributes(const Tokens& tokens, std::size_t index, std::size_t first, std::size_t parenthesis) {
    NetlistContext context{.place = Place::attribute, .owner = name_before(tokens, parenthesis, first)};
    if (tokens[first].is_word("fault")) {
        context.fault = context.owner;
        context.owner = first + 1 < tokens.size() ? tokens[first + 1].text : "";
    }
    if (tokens[index - 1].is("(") || tokens[index - 1].is(","))
        return context;
    context.place = Place::value;
    for (std::size_t i = index; i-- > parenthesis;)
        if (tokens[i].is("=") && i > parenthesis) {
            context.attribute = tokens[i - 1].text;
            break;
        }
    return context;
}

/// Returns whether the parentheses in a statement contain attributes. Otherwise they contain an expression.
bool opens_attributes(const Tokens& tokens, std::size_t first, std::size_t parenthesis) {
    static constexpr std::array<std::string_view, 4> with_expressions{"val", "rep", "if", "use"};
    const bool follows_name =
        parenthesis > first && (tokens[parenthesis - 1].kind == TokenKind::name || tokens[parenthesis - 1].is("]"));
    return follows_name && std::ranges::find(with_expressions, tokens[first].text) == with_expressions.end();
}

NetlistContext behind_word(const Tokens& tokens, std::size_t index, std::size_t first) {
    static constexpr std::array<std::string_view, 8> before_things{"connect", "place", "to", "on",
                                                                   "by",      "for",   ",",  "fault"};
    const Token& before = tokens[index - 1];
    const std::string& head = tokens[first].text;
    const bool names_thing = head == "connect" || head == "place" || head == "use" || head == "fault";
    if (head == "use" && index == first + 1)
        return {.place = Place::program};
    if (head == "fault" && index > first + 1)
        return {.place = Place::fault, .owner = tokens[first + 1].text};
    if (names_thing && std::ranges::find(before_things, before.text) != before_things.end())
        return {.place = Place::thing, .word = before.text};
    const bool declares = index == first + 1 || before.is(",") || before.is(")");
    if (declares && head != "if")
        return {.place = Place::new_name};
    return {.place = Place::value};
}

} // namespace

NetlistContext context_of(const Tokens& tokens, std::size_t index) {
    std::size_t first = statement_start(tokens, index);
    if (index > 0 && tokens[index - 1].kind == TokenKind::directive)
        return {.place = Place::file};
    if (index == first)
        return {};
    for (std::size_t i = first; i + 1 < index; ++i) // the statement may be the body of `rep`, `if` or `else`
        if (tokens[i + 1].kind == TokenKind::name && !tokens[i].is(".") && !tokens[i].is(",") && i > first &&
            std::ranges::find(statement_words(), tokens[i + 1].text) != statement_words().end() &&
            (tokens[first].is_word("rep") || tokens[first].is_word("if") || tokens[first].is_word("else")))
            first = i + 1;
    if (tokens[index - 1].is("."))
        return {.place = Place::member, .owner = name_before(tokens, index - 1, first)};
    const auto parenthesis = open_parenthesis(tokens, index, first);
    if (parenthesis && opens_attributes(tokens, first, *parenthesis))
        return in_attributes(tokens, index, first, *parenthesis);
    return parenthesis ? NetlistContext{.place = Place::value} : behind_word(tokens, index, first);
}

NetlistOwner owner_of(const NetlistSyntax& syntax, const Catalogue& catalogue, const std::string& name) {
    NetlistOwner owner{.name = syntax.find(name)};
    const std::string& type = owner.name ? owner.name->type : name;
    if (const auto found = catalogue.node_types().find(type); found != catalogue.node_types().end()) {
        owner.device = found->second.preset.kind;
        owner.links = found->second.links;
    }
    if (owner.name && !owner.name->program.empty())
        owner.kind = catalogue.find(owner.name->program);
    return owner;
}

std::vector<FaultKind> faults_of(const NetlistOwner& owner) {
    std::vector<FaultKind> faults = link_faults();
    if (owner.device)
        std::ranges::copy(owner.device->faults, std::back_inserter(faults));
    return faults;
}

std::vector<ParameterDescription> attributes_in(const NetlistSyntax& syntax, const Catalogue& catalogue,
                                                const NetlistContext& context) {
    std::vector<ParameterDescription> found;
    const auto add = [&](const std::vector<AttributeDescription>& attributes) {
        std::ranges::transform(attributes, std::back_inserter(found), &AttributeDescription::value);
    };
    const NetlistOwner owner = owner_of(syntax, catalogue, context.owner);
    if (!context.fault.empty()) {
        for (const FaultKind& each : faults_of(owner))
            if (each.name == context.fault)
                add(each.attributes);
        return found;
    }
    using Category = NetlistName::Category;
    if (context.owner == "connection" || (owner.name && owner.name->category == Category::connection))
        add(connection_attributes());
    if (owner.device)
        add(owner.device->attributes);
    if (owner.kind)
        std::ranges::copy(owner.kind->parameters, std::back_inserter(found));
    if (!owner.device && !owner.kind && context.owner != "connection")
        for (const std::string& each : process_attribute_names())
            found.push_back(description::text(each, {}, "attribute of a process"));
    return found;
}

} // namespace placedpar::editor
