#pragma once

#include "netlist/language/syntax.hpp"

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace placedpar {

struct DeclaredName {
    std::string_view name; ///< the statement's
    Location at;
};

/// What a statement declares in the block that it stands in.
std::vector<DeclaredName> declared_names(const Statement& statement);
/// Where the first of the statements that declares the name does.
std::optional<Location> declaration_among(std::span<const Statement> statements, std::string_view name);

} // namespace placedpar
