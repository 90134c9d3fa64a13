#pragma once

#include "occam/language/tree.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace placedpar::occam {

/// Holds the value of an operation on constants, or the reason why a transputer would set its error flag. Scalars have
/// the form of Constant::bits.
struct Folded {
    std::int64_t bits = 0;
    const char* error = nullptr; ///< a text such as "overflows"; null if there is a value
};

/// Returns the value of an operation on two operands of the same type, except that the right operand of a shift is an
/// INT. REQUIRES: the type has the operation.
Folded fold(Operator, Basic, std::int64_t left, std::int64_t right);
/// Returns the value of an operation on one operand. REQUIRES: the type has the operation.
Folded fold(Operator, Basic, std::int64_t operand);
/// Returns a value of another type. REQUIRES: the language has this conversion.
Folded convert(Basic from, Basic to, Conversion::Rounding, std::int64_t bits);

/// Returns the value of a literal. `is_pattern`: the literal is in hexadecimal, and may use the sign bit.
Folded integer_value(std::uint64_t value, Basic, bool is_pattern, bool negative_allowed);
Folded real_value(const std::string& digits, Basic);

/// Returns the largest or the smallest value of a type.
std::int64_t most_positive(Basic);
std::int64_t most_negative(Basic);

/// Returns the bytes of a constant in memory. REQUIRES: the type has a known size.
std::vector<std::uint8_t> memory_of(const Constant&, const Type&);
/// Returns the constant that has these bytes in memory. REQUIRES: `bytes` holds bytes_of(type) bytes from `offset`.
Constant constant_of(const std::vector<std::uint8_t>& bytes, std::size_t offset, const Type&);

/// Returns the type from which DATA TYPE derives this type: after `DATA TYPE T IS U`, plain(T) is plain(U). Returns any
/// other type unchanged.
const Type& plain(const Type&);

} // namespace placedpar::occam
