#include "occam/check/region.hpp"

#include "occam/check/constant.hpp"

#include <algorithm>
#include <unordered_set>
#include <variant>

namespace placedpar::occam {

namespace {

/// Assumed number of elements of an array of unknown size.
constexpr std::int64_t assumed_elements = std::int64_t{1} << 20;
constexpr std::int64_t most_elements = std::int64_t{1}
                                       << 40; ///< limit of sums and products of subscripts, far from overflow
constexpr std::size_t most_comparisons = 65536;

/// Returns the number of single values in a variable.
std::int64_t elements_of(const Type& type) {
    const Type& form = plain(type);
    if (form.kind == Type::Kind::array)
        return std::min(most_elements,
                        (form.count ? std::int64_t{*form.count} : assumed_elements) * elements_of(*form.element));
    std::int64_t sum = form.kind == Type::Kind::record ? 0 : 1;
    for (const Field& field : form.fields)
        sum += elements_of(*field.type);
    return sum;
}

const Expression* value_behind(const NameUse& use) {
    const auto* abbreviation = use.meaning ? std::get_if<Abbreviation>(&use.meaning->form) : nullptr;
    return abbreviation && abbreviation->is_value ? &abbreviation->value : nullptr;
}

/// Collects the indices of replicators on which expressions depend, directly or through VAL abbreviations.
class IndexCollector {
public:
    explicit IndexCollector(std::vector<const Declaration*>& indices) : indices_(indices) {}

    void add(const Expression& expression) {
        if (expression.constant)
            return;
        if (const auto* use = std::get_if<NameUse>(&expression.form)) {
            add(*use);
        } else if (const auto* binary = std::get_if<BinaryOperation>(&expression.form)) {
            add(*binary->left);
            add(*binary->right);
        } else if (const auto* unary = std::get_if<UnaryOperation>(&expression.form)) {
            add(*unary->operand);
        } else if (const auto* conversion = std::get_if<Conversion>(&expression.form)) {
            add(*conversion->operand);
        } else if (const auto* subscript = std::get_if<Subscript>(&expression.form)) {
            add(*subscript->index);
        }
    }

private:
    void add(const NameUse& use) {
        if (!use.meaning || !seen_.insert(use.meaning).second)
            return;
        const bool is_index = std::holds_alternative<ReplicatorIndex>(use.meaning->form);
        if (is_index && std::ranges::find(indices_, use.meaning) == indices_.end())
            indices_.push_back(use.meaning);
        if (const Expression* const value = value_behind(use))
            add(*value);
    }

    std::vector<const Declaration*>& indices_;
    std::unordered_set<const Declaration*> seen_;
};

/// Appends an index to `ordered`, after the indices on which the base, count and step of its replicator depend. An
/// index that has a value, or is already in `ordered`, is left out.
void add_in_order(const Declaration* index, const Replicators& replicators, const IndexValues& values,
                  std::vector<const Declaration*>& ordered) {
    if (values.contains(index) || std::ranges::find(ordered, index) != ordered.end())
        return;
    std::vector<const Declaration*> outer;
    if (const auto found = replicators.find(index); found != replicators.end() && found->second) {
        IndexCollector collector(outer);
        collector.add(found->second->base);
        collector.add(found->second->count);
    }
    for (const Declaration* const each : outer)
        add_in_order(each, replicators, values, ordered);
    ordered.push_back(index);
}

std::optional<std::int64_t> known(const Folded& folded) {
    return folded.error ? std::nullopt : std::optional(folded.bits);
}

/// Evaluates an expression with the given values of indices.
class Evaluator {
public:
    explicit Evaluator(const IndexValues& values) : values_(values) {}

    std::optional<std::int64_t> value(const Expression& expression) {
        if (expression.constant && !expression.constant->bytes)
            return expression.constant->bits;
        if (++steps_ > most_steps)
            return std::nullopt;
        if (const auto* use = std::get_if<NameUse>(&expression.form)) {
            if (const auto known_index = values_.find(use->meaning); known_index != values_.end())
                return known_index->second;
            const Expression* const behind = value_behind(*use);
            return behind ? value(*behind) : std::nullopt;
        }
        if (const auto* binary = std::get_if<BinaryOperation>(&expression.form))
            return value_in(*binary);
        if (const auto* subscript = std::get_if<Subscript>(&expression.form))
            return value_in(*subscript);
        const auto* unary = std::get_if<UnaryOperation>(&expression.form);
        const auto* conversion = std::get_if<Conversion>(&expression.form);
        const Expression* const operand = unary        ? unary->operand.get()
                                          : conversion ? conversion->operand.get()
                                                       : nullptr;
        const std::optional<std::int64_t> known_operand = operand ? value(*operand) : std::nullopt;
        if (!known_operand || plain(*expression.type).kind != Type::Kind::basic)
            return std::nullopt;
        const Basic basic = plain(*operand->type).basic;
        return unary ? known(fold(unary->operation, basic, *known_operand))
                     : known(convert(basic, plain(*expression.type).basic, conversion->rounding, *known_operand));
    }

private:
    /// Limits the steps of one evaluation. If each VAL of a chain of abbreviations uses the previous VAL twice, the
    /// number of steps doubles with each VAL.
    static constexpr std::size_t most_steps = 1000;

    std::optional<std::int64_t> value_in(const BinaryOperation& operation) {
        const std::optional<std::int64_t> left = value(*operation.left);
        const std::optional<std::int64_t> right = left ? value(*operation.right) : std::nullopt;
        return right ? known(fold(operation.operation, plain(*operation.left->type).basic, *left, *right))
                     : std::nullopt;
    }

    /// Returns the value of an element of a constant table.
    std::optional<std::int64_t> value_in(const Subscript& subscript) {
        const std::optional<Constant>& table = subscript.array->constant;
        const std::optional<std::int64_t> index = table ? value(*subscript.index) : std::nullopt;
        const Type& array = plain(*subscript.array->type);
        if (!index || !table->bytes || !array.count || *index < 0 || *index >= *array.count)
            return std::nullopt;
        const auto offset = static_cast<std::uint64_t>(*index) * bytes_of(*array.element);
        return constant_of(*table->bytes, offset, *array.element).bits;
    }

    const IndexValues& values_;
    std::size_t steps_ = 0;
};

/// Narrows a region of a variable to the part that a step, such as a subscript, selects. Returns the type of the part;
/// null if the subscript or count is unknown at compile time.
const Type* narrow(Region& region, const Type& type, const PathStep& step, const IndexValues& values) {
    const Type& form = plain(type);
    if (step.field) {
        for (std::uint32_t i = 0; i < *step.field; ++i)
            region.first += elements_of(*form.fields[i].type);
        const Type& field = *form.fields[*step.field].type;
        region.end = region.first + elements_of(field);
        return &field;
    }
    const std::optional<std::int64_t> index = step.index ? value_of(*step.index, values) : 0;
    const std::optional<std::int64_t> count = step.count ? value_of(*step.count, values) : 1;
    if (!index || !count || form.kind != Type::Kind::array)
        return nullptr;
    const std::int64_t size = elements_of(*form.element);
    const std::int64_t limit = most_elements / std::max(size, std::int64_t{1});
    region.first += std::clamp(*index, -limit, limit) * size;
    if (!step.is_segment || step.count)
        region.end = region.first + std::clamp(*count, std::int64_t{0}, limit) * size;
    return step.is_segment ? &form : form.element;
}

bool visit_values(const std::vector<const Declaration*>& indices, std::size_t next, const Replicators& replicators,
                  std::size_t& left, IndexValues& values, const std::function<bool(const IndexValues&)>& call) {
    if (next == indices.size())
        return left-- > 0 && call(values);
    const auto found = replicators.find(indices[next]);
    const Replicator* const replicator = found == replicators.end() ? nullptr : found->second;
    const std::optional<std::int64_t> base = replicator ? value_of(replicator->base, values) : std::nullopt;
    const std::optional<std::int64_t> count = replicator ? value_of(replicator->count, values) : std::nullopt;
    const std::optional<std::int64_t> step = replicator && replicator->step ? value_of(*replicator->step, values) : 1;
    if (!base || !count || !step)
        return visit_values(indices, next + 1, replicators, left, values, call);
    const std::int64_t times = count.value_or(0); // GCC 12 gives a false alarm about *count
    for (std::int64_t i = 0; i < times && left > 0; ++i) {
        values[indices[next]] = *base + i * *step;
        if (!visit_values(indices, next + 1, replicators, left, values, call))
            return false;
    }
    values.erase(indices[next]);
    return true;
}

} // namespace

std::optional<std::int64_t> value_of(const Expression& expression, const IndexValues& values) {
    return Evaluator(values).value(expression);
}

void add_indices(const Access& access, std::vector<const Declaration*>& indices) {
    IndexCollector collector(indices);
    for (const PathStep& step : access.steps) {
        if (step.index)
            collector.add(*step.index);
        if (step.count)
            collector.add(*step.count);
    }
}

Region region_of(const Access& access, const IndexValues& values) {
    const Type* type = access.base->type;
    Region region{0, elements_of(*type)};
    for (const PathStep& step : access.steps) {
        type = narrow(region, *type, step, values);
        if (!type) {
            region.is_exact = false;
            break;
        }
    }
    return region;
}

Overlap overlap_of(const Region& a, const Region& b) {
    if (a.first >= b.end || b.first >= a.end)
        return Overlap::none;
    const bool a_is_inside = a.first >= b.first && a.end <= b.end, b_is_inside = b.first >= a.first && b.end <= a.end;
    const bool is_certain = (a.is_exact && b.is_exact) || (b.is_exact && a_is_inside) || (a.is_exact && b_is_inside);
    return is_certain ? Overlap::certain : Overlap::possible;
}

Overlap overlap_of(const Access& a, const Access& b, const Replicators& replicators) {
    std::vector<const Declaration*> indices;
    add_indices(a, indices);
    add_indices(b, indices);
    Overlap worst = Overlap::none;
    IndexValues values;
    for_each_value(indices, replicators, most_comparisons, values, [&](const IndexValues& given) {
        worst = std::max(worst, overlap_of(region_of(a, given), region_of(b, given)));
        return worst != Overlap::certain;
    });
    return worst;
}

void for_each_value(const std::vector<const Declaration*>& indices, const Replicators& replicators, std::size_t most,
                    IndexValues& values, const std::function<bool(const IndexValues&)>& call) {
    std::vector<const Declaration*> ordered;
    for (const Declaration* const each : indices)
        add_in_order(each, replicators, values, ordered);
    visit_values(ordered, 0, replicators, most, values, call);
}

} // namespace placedpar::occam
