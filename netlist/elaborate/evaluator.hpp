#pragma once

#include "netlist/elaborate/scope.hpp"
#include "netlist/language/syntax.hpp"
#include "text/reporter.hpp"

#include <functional>
#include <string_view>

namespace placedpar {

/// Limits the number of steps, such as statements executed in `rep` loops, so that reading a netlist takes at most
/// seconds.
inline constexpr std::size_t most_steps = 5'000'000;

/// Evaluates the expressions of a netlist, with the names that are visible in `scopes`. All functions throw
/// StatementRefused after reporting an error.
class Evaluator {
public:
    Evaluator(const Scopes& scopes, Reporter& reporter) : scopes_(scopes), reporter_(reporter) {}

    Constant evaluate(const Expression& expression);

    /// Evaluates an expression whose value must be an integer. `whose`, such as `the attribute "memory"`, completes the
    /// message "wrong type for ...".
    Integer integer(const Expression& expression, std::string_view whose);
    /// Evaluates an expression whose value must be an integer or a real.
    double number(const Expression& expression, std::string_view whose);
    std::string text(const Expression& expression, std::string_view whose);
    bool condition(const Expression& expression);

    /// Counts one step of work. Throws GiveUp, which ends the reading of the netlist, after most_steps.
    void step(const Location& at);

private:
    Constant value_of(const IntegerLiteral& literal, const Location&) { return {literal.value}; }
    Constant value_of(const RealLiteral& literal, const Location&) { return {literal.value}; }
    Constant value_of(const TextLiteral& literal, const Location&) { return {literal.value}; }
    Constant value_of(const NameUse& use, const Location& at);
    Constant value_of(const UnaryOperation& operation, const Location& at);
    Constant value_of(const BinaryOperation& operation, const Location& at);
    Constant value_of(const ConditionalOperation& operation, const Location& at);
    Constant value_of(const SizeOperation& operation, const Location& at);
    Constant value_of(const CastOperation& operation, const Location& at);
    Constant value_of(const SubscriptOperation& operation, const Location& at);
    Constant value_of(const ArrayConstant& array, const Location& at);
    void check_shape(const Constant& first, const Constant& element, const Location& array, const Location& at);
    Constant evaluate_logical(const BinaryOperation& operation, const Location& at);
    [[noreturn]] void wrong_type(const Expression& expression, const Constant& value, std::string_view whose,
                                 std::string hint);
    [[noreturn]] void refuse(const Location& at, std::string message, std::string hint = "",
                             std::vector<SecondPlace> others = {});

    const Scopes& scopes_;
    Reporter& reporter_;
    std::size_t steps_ = 0;
};

/// Reports that the name is undefined. If a later statement declares the name, a note shows the place. Otherwise a hint
/// suggests the most similar name that `known` returns, or the most similar visible name if `known` is empty. Throws
/// StatementRefused.
[[noreturn]] void refuse_undefined(Reporter& reporter, const Scopes& scopes, const std::string& name,
                                   const Location& at, const std::function<std::vector<std::string>()>& known = {});

} // namespace placedpar
