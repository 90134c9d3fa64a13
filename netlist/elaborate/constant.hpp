#pragma once

#include "netlist/language/token.hpp"

#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace placedpar {

inline constexpr int deepest_array = 8;

struct Constant;
using ConstantArray = std::shared_ptr<const std::vector<Constant>>;

/// Holds the value of an expression in a netlist. Characters are integers. `TRUE`, `FALSE`, `HIGH` and `LOW` are
/// integers, too.
struct Constant {
    std::variant<Integer, double, std::string, ConstantArray> value;
    int depth = 0; ///< levels of nested arrays: 1 for `{1, 2}`; 0 if the value is not an array

    const Integer* integer() const { return std::get_if<Integer>(&value); }
    const double* real() const { return std::get_if<double>(&value); }
    const std::string* text() const { return std::get_if<std::string>(&value); }
    const ConstantArray* array() const { return std::get_if<ConstantArray>(&value); }
    bool is_number() const { return integer() != nullptr || real() != nullptr; }
};

Constant integer_constant(std::int64_t value);
/// Returns the number as a real. REQUIRES: the constant is a number.
double as_real(const Constant& constant);

/// Returns "an integer", "a real number", "a string" or "an array".
std::string type_name(const Constant& constant);
/// Returns the constant in the syntax of a netlist. A long text is shortened.
std::string shown(const Constant& constant);

/// The operations below throw this exception if the language defines no result for the operands. The caller, Evaluator,
/// then reports an error at the place of the operation.
struct NoResult {
    std::string message;
    std::string hint;
};

/// These functions apply an operator. Integers have 64 bits; an overflow throws NoResult. If an operand is real, the
/// result is real. Evaluator handles `&&` and `||`, which may leave the right operand unevaluated.
Constant apply_unary(const std::string& symbol, const Constant& operand);
Constant apply_binary(const std::string& symbol, const Constant& left, const Constant& right);
/// Converts to a type. A real is truncated towards zero. Throws NoResult if the value is out of the range of `char`,
/// `short` or `int`.
Constant apply_cast(const std::string& type, const Constant& operand);
Constant apply_subscript(const Constant& array, const Constant& subscript);
/// Returns the number of elements of an array, or of characters of a string.
Constant apply_size(const Constant& array);

/// Returns whether both constants have the same type and, for arrays, the same dimensions. Integers and reals count as
/// one type. REQUIRES: in each array, all elements have the same shape.
bool have_same_shape(const Constant& left, const Constant& right);

} // namespace placedpar
