#pragma once

#include "netlist/elaborate/draft.hpp"
#include "netlist/kinds/parameter.hpp"

#include <optional>
#include <string>

namespace placedpar {

/// These functions check values against the type that the interface of a process declares for a parameter.

/// Tells in `message` why a value does not fit the type, and in `hint` what would fit.
struct Misfit {
    std::string message, hint;
};

/// Returns the type of the parameter's elements. An array of `char` is a text; the last dimension of `char name[3][8]`
/// therefore makes three texts, the elements.
ParameterType element_type(const ParameterDeclaration& parameter);
/// Returns the number of subscripts of an element: the number of dimensions, or one less if the elements are texts.
std::size_t element_dimensions(const ParameterDeclaration& parameter);
/// Returns the reason if an element of the parameter cannot hold the value: a number is out of range, or a text is too
/// long. A `char` has 8 bits, a `short` 16 bits, an `int` or `unsigned` 32 bits as on a T800, and a `long` 64 bits.
std::optional<Misfit> misfit(const ParameterDeclaration& parameter, const Value& value);

/// Returns the declaration as text, such as "char name[3][8]".
std::string declaration_of(const ParameterDeclaration& parameter);

} // namespace placedpar
