#include "occam/check/checker.hpp"
#include "occam/check/usage.hpp"

#include <algorithm>
#include <utility>
#include <variant>

namespace placedpar::occam {

namespace {

/// Appends the steps of a path to the steps of its root. Returns false if the root is not a name.
bool add_steps(const Expression& expression, std::vector<PathStep>& steps, const Declaration*& root) {
    if (const auto* use = std::get_if<NameUse>(&expression.form)) {
        root = use->meaning;
        return root != nullptr;
    }
    if (const auto* subscript = std::get_if<Subscript>(&expression.form)) {
        const bool is_path = add_steps(*subscript->array, steps, root);
        PathStep step{.index = subscript->index.get()};
        if (subscript->field)
            step = {.field = subscript->field};
        steps.push_back(step);
        return is_path;
    }
    const auto* segment = std::get_if<Segment>(&expression.form);
    if (!segment || !add_steps(*segment->array, steps, root))
        return false;
    steps.push_back({.index = segment->from.get(), .count = segment->count.get(), .is_segment = true});
    return true;
}

/// If the root is an abbreviation, replaces it by the variable that the abbreviation names.
void resolve(Access& access) {
    while (const auto* abbreviation = std::get_if<Abbreviation>(&access.base->form)) {
        std::vector<PathStep> steps;
        const Declaration* root = nullptr;
        if (abbreviation->is_value || !add_steps(abbreviation->value, steps, root))
            return;
        access.steps.insert(access.steps.begin(), steps.begin(), steps.end());
        access.base = root;
    }
}

} // namespace

std::optional<Access> UsageCheck::access_of(const Expression& expression, AccessKind kind) const {
    Access access{.kind = kind, .at = expression.at};
    if (!add_steps(expression, access.steps, access.root) || !access.root->type)
        return std::nullopt;
    access.base = access.root;
    resolve(access);
    const Type::Kind form = innermost(*access.base->type).kind;
    if (form == Type::Kind::timer || form == Type::Kind::mistaken)
        return std::nullopt;
    return access;
}

std::vector<Access> UsageCheck::accesses_since(std::size_t first) const {
    return {log_.begin() + static_cast<std::ptrdiff_t>(first), log_.end()};
}

void UsageCheck::log(Access access) {
    check_active(access);
    log_.push_back(std::move(access));
}

void UsageCheck::use(const Expression& expression, AccessKind kind) {
    read_indices(expression);
    if (std::optional<Access> access = access_of(expression, kind))
        log(std::move(*access));
}

void UsageCheck::read_indices(const Expression& expression) {
    if (const auto* subscript = std::get_if<Subscript>(&expression.form)) {
        read_indices(*subscript->array);
        if (!subscript->field)
            read(*subscript->index);
    } else if (const auto* segment = std::get_if<Segment>(&expression.form)) {
        read_indices(*segment->array);
        if (segment->from)
            read(*segment->from);
        if (segment->count)
            read(*segment->count);
    }
}

void UsageCheck::read_path(const Expression& expression) {
    std::vector<PathStep> steps;
    const Declaration* root = nullptr;
    if (add_steps(expression, steps, root))
        return use(expression, AccessKind::read);
    if (const auto* subscript = std::get_if<Subscript>(&expression.form))
        read(*subscript->array);
    else if (const auto* segment = std::get_if<Segment>(&expression.form))
        read(*segment->array);
    read_indices(expression);
}

void UsageCheck::read(const Expression& expression) {
    if (expression.constant)
        return;
    if (const auto* table = std::get_if<TableLiteral>(&expression.form)) {
        for (const Expression& each : table->elements)
            read(each);
    } else if (const auto* unary = std::get_if<UnaryOperation>(&expression.form)) {
        if (unary->operation != Operator::size)
            read(*unary->operand);
    } else if (const auto* binary = std::get_if<BinaryOperation>(&expression.form)) {
        read(*binary->left);
        read(*binary->right);
    } else if (const auto* conversion = std::get_if<Conversion>(&expression.form)) {
        read(*conversion->operand);
    } else if (const auto* function = std::get_if<Call>(&expression.form)) {
        if (function->meaning)
            call(*function->meaning, function->arguments, expression.at);
    } else if (const auto* process = std::get_if<ValueProcess>(&expression.form)) {
        const std::size_t active = active_.size();
        visit_values(*process);
        active_.resize(active);
    } else {
        read_path(expression);
    }
}

UsageCheck::Part UsageCheck::changed_part(const Expression& expression) {
    const std::size_t first = log_.size();
    read_indices(expression);
    Part part{access_of(expression, AccessKind::write), accesses_since(first)};
    if (part.changed)
        log(*part.changed);
    return part;
}

UsageCheck::Part UsageCheck::read_part(const Expression& expression) {
    const std::size_t first = log_.size();
    read(expression);
    return {std::nullopt, accesses_since(first)};
}

UsageCheck::Part UsageCheck::argument(const Expression& expression, const Declaration& routine, std::size_t index) {
    const auto* procedure = std::get_if<Procedure>(&routine.form);
    const auto* predefined = std::get_if<Predefined>(&routine.form);
    Parameter::Passing passing = Parameter::Passing::value;
    Direction direction = Direction::unused;
    if (procedure && index < procedure->parameters.size()) {
        const Declaration& parameter = *procedure->parameters[index];
        passing = std::get<Parameter>(parameter.form).passing;
        direction = parameter.direction;
    } else if (predefined && index < predefined->passing.size()) {
        passing = predefined->passing[index];
    }
    if (expression.type && !is_data(*expression.type)) {
        if (direction != Direction::unused)
            use(expression, direction == Direction::input ? AccessKind::input : AccessKind::output);
        return {};
    }
    return passing == Parameter::Passing::value ? read_part(expression) : changed_part(expression);
}

void UsageCheck::call(const Declaration& routine, const std::vector<Expression>& arguments, const Place& place) {
    std::vector<Part> parts;
    for (std::size_t i = 0; i < arguments.size(); ++i)
        parts.push_back(argument(arguments[i], routine, i));
    if (aliases_) {
        check_parts(parts, true, "by parameters of \"" + routine.name + "\"");
        check_free(routine, parts, place);
    }
    const auto summary = summaries_.find(&routine);
    if (summary == summaries_.end())
        return;
    for (Access access : summary->second) {
        access.at = place;
        access.through = &routine;
        log(std::move(access));
    }
}

} // namespace placedpar::occam
