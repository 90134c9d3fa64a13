#pragma once

#include "netlist/elaborate/draft.hpp"
#include "netlist/kinds/parameter.hpp"

#include <optional>
#include <string>

namespace placedpar {

/// What the type that an interface declares for a parameter says about its values.

/// Why a value does not fit, and what would.
struct Misfit {
    std::string message, hint;
};

/// The type of the parameter's elements: a row of `char` is one text.
ParameterType element_type(const ParameterDeclaration& parameter);
/// How many subscripts an element has: one less than dimensions where rows of `char` are texts.
std::size_t element_dimensions(const ParameterDeclaration& parameter);
/// Whether an element of the parameter can hold the value: numbers have ranges, a text its length. A char, short, int
/// and unsigned have 8, 16, 32 and 32 bits, as on a T800; a long has 64.
std::optional<Misfit> misfit(const ParameterDeclaration& parameter, const Value& value);

/// "char name[3][8]", as it is declared.
std::string declaration_of(const ParameterDeclaration& parameter);

} // namespace placedpar
