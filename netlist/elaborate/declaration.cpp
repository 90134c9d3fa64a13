#include "netlist/elaborate/attribute_value.hpp"
#include "netlist/elaborate/elaborator.hpp"
#include "netlist/language/lexer.hpp"

#include "netlist/language/parser.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar {

void Elaborator::check_free(const std::string& name, const Location& at) {
    if (const auto* known = scopes_.find_in_this_block(name))
        refuse(at, fmt::format("the name \"{}\" is declared twice", name), "",
               {{fmt::format("first declared here, as {}", describe(*known)), known->declared}});
}

/// Returns the name. If the network already has this name, appends a number: a block in a `rep` statement declares its
/// names once for each repetition.
std::string Elaborator::claim_name(const std::string& name) {
    auto claimed = name;
    auto& number = copies_[name];
    number = std::max(number, 1);
    constexpr std::size_t longest_number = std::string_view("_250000").size();
    while (!claimed_.insert(claimed).second)
        claimed = fmt::format("{}_{}", name.substr(0, longest_name - longest_number), ++number);
    return claimed;
}

void Elaborator::count_things(std::size_t count, const Location& at) {
    draft_.things += count;
    if (draft_.things > most_things)
        reporter_.give_up(at, fmt::format("the network is too large: it may have at most {} nodes, connections, "
                                          "processes, channel ends and parameters in all",
                                          most_things));
}

std::vector<std::int64_t> Elaborator::dimensions(const Declarator& declarator) {
    if (declarator.dimensions.size() > most_dimensions)
        refuse(declarator.dimensions[most_dimensions]->at,
               fmt::format("\"{}\" has too many dimensions: {}", declarator.name, declarator.dimensions.size()),
               fmt::format("at most {} are allowed", most_dimensions));
    std::vector<std::int64_t> sizes;
    std::size_t product = 1;
    for (const auto& expression : declarator.dimensions) {
        auto size = evaluator_.integer(*expression, "a dimension").value;
        if (size < 1)
            refuse(expression->at, fmt::format("illegal dimension size {} of \"{}\"", size, declarator.name),
                   "expected at least 1; to leave an array out, declare it inside an \"if\"");
        if (static_cast<std::uint64_t>(size) > most_things || (product *= static_cast<std::size_t>(size)) > most_things)
            refuse(expression->at,
                   fmt::format("illegal dimension size {} of \"{}\": the array is too large", size, declarator.name),
                   fmt::format("a network has at most {} nodes, connections, processes, channel ends and "
                               "parameters",
                               most_things));
        sizes.push_back(size);
    }
    return sizes;
}

void Elaborator::declare(const Declarator& declarator, Category category, std::size_t first,
                         const std::function<void(std::string)>& add, std::size_t weight) {
    check_free(declarator.name, declarator.at);
    auto sizes = dimensions(declarator);
    auto count = element_count(sizes);
    count_things(count * weight, declarator.at);
    auto base = claim_name(declarator.name);
    for (std::size_t i = 0; i < count; ++i)
        add(element_name(base, element_subscripts(i, sizes)));
    scopes_.declare(declarator.name, {DeclaredThings{category, first, sizes}, declarator.at});
}

Type Elaborator::base_type(const std::string& name, const Location& at, std::vector<Setting>& settings) {
    const auto* symbol = scopes_.find(name);
    if (symbol == nullptr)
        refuse_undefined(reporter_, scopes_, name, at, [&] {
            auto known = scopes_.type_names();
            known.insert(known.begin(), word_meant(name)); // if two names are equally near, the first is suggested
            return known;
        });
    if (std::holds_alternative<AnyElement>(symbol->meaning))
        return type_of_element(at, settings);
    if (const auto* type = std::get_if<ProcessType>(&symbol->meaning))
        return *type;
    const auto* type = std::get_if<NodeType>(&symbol->meaning);
    if (type == nullptr)
        refuse(at, fmt::format("\"{}\" is {}, not a node type", name, describe(*symbol)));
    if (const auto& refusal = type->preset.kind->refusal; !refusal.empty())
        refuse(at, fmt::format("a {} cannot be declared: {}", name, refusal));
    return *type;
}

Type Elaborator::type_of_element(const Location& at, std::vector<Setting>& settings) {
    auto found = std::ranges::find(settings, "element", &Setting::name);
    if (found == settings.end())
        refuse(at, "the attribute \"element\" of this node is missing",
               "write node (element = \"processor\") or node (element = \"process\")");
    AttributeValue value(*found, reporter_);
    auto element = value.text();
    if (element != "processor" && element != "process")
        value.illegal(fmt::format("\"{}\"", element), "expected \"processor\" or \"process\"");
    settings.erase(found);
    if (element == "process")
        return ProcessType{};
    return catalogue_.node_types().find(element)->second;
}

Type Elaborator::derived_type(const std::string& name, const Location& at, const DeclarationAttributes& attributes) {
    auto settings = evaluate_attributes(evaluator_, reporter_, attributes.attributes);
    auto type = base_type(name, at, settings);
    if (auto* processes = std::get_if<ProcessType>(&type)) {
        extend(*processes, settings, attributes);
        return type;
    }
    if (attributes.interface)
        refuse(attributes.interface_at, "a node has no attribute \"interface\"", "only a process has an interface");
    apply_node_attributes(std::get<NodeType>(type), settings, scopes_, reporter_);
    return type;
}

void Elaborator::perform(const DefineStatement& form, const Location&) {
    auto type = derived_type(form.base, form.base_at, form.attributes);
    for (const auto& name : form.names) {
        check_free(name.name, name.at);
        scopes_.declare(name.name, std::visit([&](auto& each) { return Symbol{each, name.at}; }, type));
    }
}

void Elaborator::perform(const Declaration& form, const Location&) {
    auto type = derived_type(form.type, form.type_at, form.attributes);
    if (auto* nodes = std::get_if<NodeType>(&type))
        return declare_nodes(*nodes, form);
    auto& processes = std::get<ProcessType>(type);
    if (!form.names.empty())
        return declare_processes(processes, form.names);
    auto& defaults = process_defaults_.settings;
    defaults.insert(defaults.end(), processes.settings.begin(), processes.settings.end());
    if (processes.interface)
        process_defaults_.interface = processes.interface;
}

void Elaborator::declare_nodes(const NodeType& type, const Declaration& form) {
    if (type.needs_type)
        refuse(form.type_at, "the type of the processor is missing", "write processor (type = \"T800\") name;");
    for (const auto& name : form.names)
        declare(
            name, Category::node, draft_.nodes.size(),
            [&](std::string unique) {
                auto node = type.preset;
                node.name = std::move(unique);
                node.declared = name.at;
                draft_.nodes.push_back(std::move(node));
                draft_.links.push_back(type.links);
            },
            1 + type.preset.other.size());
}

void Elaborator::perform(const ConnectionDeclaration& form, const Location&) {
    auto settings = evaluate_attributes(evaluator_, reporter_, form.attributes);
    DraftConnection pattern;
    apply_connection_attributes(pattern, settings, reporter_);
    for (const auto& name : form.names)
        declare(name, Category::connection, draft_.connections.size(), [&](std::string unique) {
            auto connection = pattern;
            connection.name = std::move(unique);
            connection.declared = name.at;
            draft_.connections.push_back(std::move(connection));
        });
}

void Elaborator::perform(const EdgeChannelDeclaration& form, const Location&) {
    for (const auto& name : form.names)
        declare(name, Category::edge_channel, draft_.edge_channels.size(), [&](std::string unique) {
            draft_.edge_channels.push_back({std::move(unique), form.direction, name.at, std::nullopt, nowhere, {}});
        });
}

} // namespace placedpar
