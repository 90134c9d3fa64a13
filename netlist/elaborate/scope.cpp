#include "netlist/elaborate/scope.hpp"

#include "netlist/elaborate/declared_names.hpp"

#include <algorithm>

namespace placedpar {

std::string describe(const Symbol& symbol) {
    if (std::holds_alternative<Constant>(symbol.meaning))
        return "a val";
    if (std::holds_alternative<NodeType>(symbol.meaning) || std::holds_alternative<AnyElement>(symbol.meaning))
        return "a node type";
    if (std::holds_alternative<ProcessType>(symbol.meaning))
        return "a process type";
    const auto& things = std::get<DeclaredThings>(symbol.meaning);
    std::string array = things.dimensions.empty() ? "a" : "an array of";
    std::string plural = things.dimensions.empty() ? "" : "s";
    switch (things.category) {
    case DeclaredThings::Category::node: return array + " node" + plural;
    case DeclaredThings::Category::connection: return array + " connection" + plural;
    case DeclaredThings::Category::edge_channel:
        return (things.dimensions.empty() ? "an edge channel" : "an array of edge channels");
    case DeclaredThings::Category::process: break;
    }
    return array + " process" + (plural.empty() ? "" : "es");
}

namespace {

ProcessType process_type_of_priority(std::int64_t priority) {
    return {{{"priority", integer_constant(priority), {}}}, nullptr};
}

} // namespace

Scopes::Scopes(const Catalogue& catalogue) : scopes_(2) {
    for (const auto* name : {"TRUE", "true", "LOW", "low"})
        declare_predefined(name, {integer_constant(1), {}});
    for (const auto* name : {"FALSE", "false", "HIGH", "high"})
        declare_predefined(name, {integer_constant(0), {}});
    for (const auto& [name, type] : catalogue.node_types())
        declare_predefined(name, {type, {}});
    declare_predefined("node", {AnyElement{}, {}});
    for (const auto* name : {"process", "PROCESS"})
        declare_predefined(name, {ProcessType{}, {}});
    for (const auto* name : {"highprocess", "HIGHPROCESS"})
        declare_predefined(name, {process_type_of_priority(0), {}});
    for (const auto* name : {"lowprocess", "LOWPROCESS"})
        declare_predefined(name, {process_type_of_priority(1), {}});
}

const Symbol* Scopes::find(std::string_view name) const {
    for (auto scope = scopes_.rbegin(); scope != scopes_.rend(); ++scope)
        if (auto found = scope->find(name); found != scope->end())
            return &found->second;
    return nullptr;
}

const Symbol* Scopes::find_in_this_block(std::string_view name) const {
    auto found = scopes_.back().find(name);
    return found == scopes_.back().end() ? nullptr : &found->second;
}

std::optional<Location> Scopes::declared_later(std::string_view name) const {
    for (auto ahead = ahead_.rbegin(); ahead != ahead_.rend(); ++ahead)
        if (auto found = declaration_among(*ahead, name))
            return found;
    return std::nullopt;
}

void Scopes::declare(const std::string& name, Symbol symbol) {
    scopes_.back().insert_or_assign(name, std::move(symbol));
}

void Scopes::declare_predefined(const std::string& name, Symbol symbol) {
    scopes_.front().insert_or_assign(name, std::move(symbol));
}

std::vector<std::string> Scopes::predefined_node_types() const {
    std::vector<std::string> names;
    for (const auto& [name, symbol] : scopes_.front())
        if (std::holds_alternative<NodeType>(symbol.meaning))
            names.push_back(name);
    return names;
}

std::vector<std::string> Scopes::type_names() const {
    auto is_no_type = [this](const std::string& name) {
        const auto& meaning = find(name)->meaning;
        return std::holds_alternative<Constant>(meaning) || std::holds_alternative<DeclaredThings>(meaning);
    };
    auto types = names();
    std::erase_if(types, is_no_type);
    return types;
}

std::vector<std::string> Scopes::names() const {
    std::vector<std::string> names;
    for (auto scope = scopes_.rbegin(); scope != scopes_.rend(); ++scope)
        for (const auto& [name, entry] : *scope)
            names.push_back(name);
    return names;
}

} // namespace placedpar
