#pragma once

#include "netlist/elaborate/draft.hpp"
#include "netlist/kinds/parameter.hpp"

#include <optional>
#include <string>

namespace placedpar {

/// These functions check values against the type that an interface declares for a parameter.

/// States in `message` why a value does not fit, and in `hint` what would fit.
struct Misfit {
    std::string message, hint;
};

/// Returns the type of the parameter's elements. A row of `char` counts as one element, a text.
ParameterType element_type(const ParameterDeclaration& parameter);
/// Returns the number of subscripts of an element: the number of dimensions, or one less if rows of `char` are texts.
std::size_t element_dimensions(const ParameterDeclaration& parameter);
/// Returns a misfit if an element of the parameter cannot hold the value: a number out of range, or a text that is too
/// long. A `char` has 8 bits, a `short` 16, an `int` and an `unsigned` 32 as on a T800, a `long` 64.
std::optional<Misfit> misfit(const ParameterDeclaration& parameter, const Value& value);

/// Returns the declaration as text, such as "char name[3][8]".
std::string declaration_of(const ParameterDeclaration& parameter);

} // namespace placedpar
