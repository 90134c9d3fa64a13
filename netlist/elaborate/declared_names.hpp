#pragma once

#include "netlist/language/syntax.hpp"

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace placedpar {

struct DeclaredName {
    std::string_view name; ///< points into the statement, which must outlive this object
    Location at;
};

/// Returns the names that a statement declares. Names declared in an inner block are not visible outside, so they are
/// left out.
std::vector<DeclaredName> declared_names(const Statement& statement);
/// Returns the place of the first declaration of the name in the statements; nothing if they do not declare the name.
std::optional<Location> declaration_among(std::span<const Statement> statements, std::string_view name);

} // namespace placedpar
