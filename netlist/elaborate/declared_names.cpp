#include "netlist/elaborate/declared_names.hpp"

#include <algorithm>
#include <iterator>

namespace placedpar {

namespace {

template <class Form>
std::vector<DeclaredName> names_of(const Form&, const Location&) {
    return {};
}

std::vector<DeclaredName> names_of(const ValStatement& form, const Location& at) { return {{form.name, at}}; }

template <class Form>
requires requires(const Form& form) { form.names; }
std::vector<DeclaredName> names_of(const Form& form, const Location&) {
    std::vector<DeclaredName> names;
    for (const Declarator& declarator : form.names)
        names.push_back({declarator.name, declarator.at});
    return names;
}

/// Returns the names that an `if` declares in the enclosing block. A branch in braces declares names only for itself.
std::vector<DeclaredName> names_of(const IfStatement& form, const Location&) {
    auto names = declared_names(*form.then);
    if (form.otherwise)
        std::ranges::move(declared_names(*form.otherwise), std::back_inserter(names));
    return names;
}

} // namespace

std::vector<DeclaredName> declared_names(const Statement& statement) {
    return std::visit([&](const auto& form) { return names_of(form, statement.at); }, statement.form);
}

std::optional<Location> declaration_among(std::span<const Statement> statements, std::string_view name) {
    for (const auto& statement : statements)
        for (const auto& declared : declared_names(statement))
            if (declared.name == name)
                return declared.at;
    return std::nullopt;
}

} // namespace placedpar
