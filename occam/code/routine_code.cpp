#include "occam/code/generator.hpp"

#include <algorithm>
#include <array>

namespace placedpar::occam {

using transputer::Operation;

// Where the transputer has no instruction, the code calls a routine of the library predef.lib: for predefined routines,
// and for the arithmetic of reals without a floating-point unit. In these routines, a REAL32 is a word, and a REAL64 is
// two words, like an INT64.

namespace {

/// States what it means if a routine whose name ends with `name` sets the error flag.
struct Errors {
    std::string_view name, meaning;
};
constexpr std::array<Errors, 11> errors_by_end = {{{".add", " +: overflow, an infinity or a NaN"},
                                                   {".subtract", " -: overflow, an infinity or a NaN"},
                                                   {".multiply", " *: overflow, an infinity or a NaN"},
                                                   {".divide", " /: overflow, division by zero, an infinity or a NaN"},
                                                   {"REM", " \\: division by zero, an infinity or a NaN"},
                                                   {".negate", " -: an infinity or a NaN"},
                                                   {".equal", ": a comparison with an infinity or a NaN"},
                                                   {".greater", ": a comparison with an infinity or a NaN"},
                                                   {".INT", ": the real does not fit in INT"},
                                                   {".INT64", ": the real does not fit in INT64"},
                                                   {".REAL32", ": the real does not fit in REAL32"}}};

/// Returns what it means if the routine sets the error flag. A routine has the name of a predefined routine, or a name
/// such as "REAL32.add" for an operation, or the names of two types, joined by a dot, for a conversion.
std::string errors_of(const std::string& routine) {
    for (const Errors& each : errors_by_end)
        if (routine.ends_with(each.name))
            return routine.substr(0, routine.size() - each.name.size()) + std::string(each.meaning);
    return routine + (routine.ends_with("2D") ? ": bytes outside of an array" : ": the result is not a finite number");
}

} // namespace

void Generator::declare_library() {
    for (const DeclarationBox& each : program_.routines) {
        declare(*each);
        if (const auto routine = routines_.find(each.get()); routine != routines_.end())
            routine->second->errors = errors_of(each->name);
    }
}

const Declaration& Generator::library_routine(const Place& at, const std::string& name) const {
    const auto found = std::ranges::find(program_.routines, name, [](const auto& each) { return each->name; });
    if (found == program_.routines.end())
        refuse(at, "the library of routines has no " + name);
    return **found;
}

namespace {

/// Returns the second part of the name of the routine for an operation, such as ".add".
const char* verb_of(Operator operation) {
    switch (operation) {
    case Operator::add: return ".add";
    case Operator::subtract: return ".subtract";
    case Operator::multiply: return ".multiply";
    case Operator::divide: return ".divide";
    case Operator::remainder: return "REM";
    case Operator::equal:
    case Operator::unequal: return ".equal";
    default: return ".greater";
    }
}

} // namespace

/// Returns the routine for an operation on reals; nothing if the expression is not such an operation, or if the
/// processor has a floating-point unit.
std::optional<Generator::RealRoutine> Generator::real_routine(const Expression& e) const {
    if (has_reals() || e.constant)
        return std::nullopt;
    if (const auto* operation = std::get_if<UnaryOperation>(&e.form)) {
        if (operation->operation == Operator::size || !has_real_type(*operation->operand->type))
            return std::nullopt;
        return RealRoutine{name_of(plain(*e.type)) + ".negate", {operation->operand.get()}};
    }
    if (const auto* operation = std::get_if<BinaryOperation>(&e.form)) {
        const Operator kind = operation->operation;
        const Expression *left = operation->left.get(), *right = operation->right.get();
        if (!has_real_type(*left->type))
            return std::nullopt;
        if (kind == Operator::less || kind == Operator::greater_or_equal)
            std::swap(left, right);
        return RealRoutine{.name = name_of(plain(*left->type)) + verb_of(kind),
                           .operands = {left, right},
                           .negated = kind == Operator::unequal || kind == Operator::less_or_equal ||
                                      kind == Operator::greater_or_equal};
    }
    const auto* converted = std::get_if<Conversion>(&e.form);
    if (!converted || is_compound(plain(*e.type)))
        return std::nullopt;
    const Type &from = plain(*converted->operand->type), &to = plain(*e.type);
    if ((!has_real_type(from) && !has_real_type(to)) || from.basic == to.basic)
        return std::nullopt;
    const auto name = [&](const Type& type) {
        return has_real_type(type) ? name_of(type) : is_wide(type) ? "INT64" : "INT";
    };
    return RealRoutine{.name = std::string(name(from)) + "." + std::string(name(to)),
                       .operands = {converted->operand.get()},
                       .mode = converted->rounding == Conversion::Rounding::truncate ? 0 : 1};
}

/// Generates a call of a library routine. If `results` is empty, the only result stays in a register.
void Generator::call_real_routine(const Expression& e, const RealRoutine& routine,
                                  const std::vector<Storage>& results) {
    Arguments mode;
    if (routine.mode)
        mode.push_back({1, [this, &routine] { constant(*routine.mode); }});
    call(library_routine(e.at, routine.name), routine.operands, results, std::move(mode));
    stack_ = results.empty() ? 1 : 0;
    if (routine.negated)
        op(Operation::eqc, 0);
    if (routine.mode && results.empty() && size_of(*e.type) < 4)
        fit(*e.type, true);
}

} // namespace placedpar::occam
