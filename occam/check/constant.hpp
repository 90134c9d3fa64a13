#pragma once

#include "occam/language/tree.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace placedpar::occam {

/// The value of an operation on constants, or the reason why the machine would set its error flag. Scalars are in the
/// form of Constant::bits.
struct Folded {
    std::int64_t bits = 0;
    const char* error = nullptr; ///< a text such as "overflows"; null if there is a value
};

/// Returns the value of an operation on two operands of one type; the right operand of a shift is an INT.
/// REQUIRES: the type has the operation.
Folded fold(Operator, Basic, std::int64_t left, std::int64_t right);
/// Returns the value of an operation on one operand. REQUIRES: the type has the operation.
Folded fold(Operator, Basic, std::int64_t operand);
/// Returns a value of another type. REQUIRES: the language has this conversion.
Folded convert(Basic from, Basic to, Conversion::Rounding, std::int64_t bits);

/// Returns the value of a literal. If `is_pattern`, the literal was written in hexadecimal, and may use the sign bit.
Folded integer_value(std::uint64_t value, Basic, bool is_pattern, bool negative_allowed);
Folded real_value(const std::string& digits, Basic);

/// Returns the largest or the smallest value of a type.
std::int64_t most_positive(Basic);
std::int64_t most_negative(Basic);

/// Returns the bytes of a constant as they are in memory. REQUIRES: the type has a known size.
std::vector<std::uint8_t> memory_of(const Constant&, const Type&);
/// Returns the constant that these bytes of memory are. REQUIRES: `bytes` holds bytes_of(type) bytes from `offset`.
Constant constant_of(const std::vector<std::uint8_t>& bytes, std::size_t offset, const Type&);

/// Returns the type that has the same bits and operations: for a DATA TYPE T IS U, the plain type of U.
const Type& plain(const Type&);

} // namespace placedpar::occam
