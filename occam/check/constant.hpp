#pragma once

#include "occam/language/tree.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace placedpar::occam {

/// Holds the value of an operation on constants, which the compiler computes in place of the transputer. If the
/// operation would set the transputer's error flag, holds the reason. The functions below take and return scalars in
/// the form of Constant::bits (occam/language/tree.hpp).
struct Folded {
    std::int64_t bits = 0;
    const char* error = nullptr; ///< a text such as "overflows"; null if there is a value
};

/// Returns the value of an operation on two operands of this type. For a shift, the right operand is an INT. REQUIRES:
/// the type has the operation.
Folded fold(Operator, Basic, std::int64_t left, std::int64_t right);
/// Returns the value of an operation on one operand. REQUIRES: the type has the operation.
Folded fold(Operator, Basic, std::int64_t operand);
/// Returns a value of type `from` converted to type `to`. REQUIRES: the language has this conversion.
Folded convert(Basic from, Basic to, Conversion::Rounding, std::int64_t bits);

/// Returns the value of a literal. `is_pattern` is true for a hexadecimal literal, which may use the sign bit.
/// `negative_allowed` is true for a literal that directly follows a minus sign: a type of n bits then allows 2^(n-1).
Folded integer_value(std::uint64_t value, Basic, bool is_pattern, bool negative_allowed);
Folded real_value(const std::string& digits, Basic);

/// Returns the largest or the smallest value of a type.
std::int64_t most_positive(Basic);
std::int64_t most_negative(Basic);

/// Returns the bytes of a constant in a transputer's memory. REQUIRES: the type has a known size.
std::vector<std::uint8_t> memory_of(const Constant&, const Type&);
/// Returns the constant that has these bytes in memory. REQUIRES: `bytes` holds bytes_of(type) bytes from `offset`.
Constant constant_of(const std::vector<std::uint8_t>& bytes, std::size_t offset, const Type&);

/// Returns the type without the names that DATA TYPE gives: after `DATA TYPE T IS INT`, plain(T) is INT. Returns any
/// other type unchanged.
const Type& plain(const Type&);

} // namespace placedpar::occam
