#pragma once

#include "netlist/language/syntax.hpp"

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace placedpar {

struct DeclaredName {
    std::string_view name; ///< refers to the statement's text
    Location at;
};

/// Returns the names that a statement declares in its own block.
std::vector<DeclaredName> declared_names(const Statement& statement);
/// Returns where the name is first declared among the statements; nothing if no statement declares it.
std::optional<Location> declaration_among(std::span<const Statement> statements, std::string_view name);

} // namespace placedpar
