#include "occam/configuration/configurer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

namespace placedpar::occam {

namespace {

constexpr std::size_t largest_object =
    250'000; ///< largest number of elements of an array of channels, nodes, arcs or edges

} // namespace

std::size_t count_of_elements(const Type& type) {
    return type.kind == Type::Kind::array ? std::size_t{type.count.value_or(0)} * count_of_elements(*type.element) : 1;
}

std::vector<std::int64_t> subscripts_of(const Configured& configured, const Element& element) {
    std::vector<std::int64_t> subscripts;
    std::size_t index = element.index;
    for (const Type* type = configured.objects[element.object].type; type->kind == Type::Kind::array;
         type = type->element) {
        const std::size_t each = std::max<std::size_t>(count_of_elements(*type->element), 1);
        subscripts.push_back(static_cast<std::int64_t>(index / each));
        index %= each;
    }
    return subscripts;
}

std::string text_of(const Configured& configured, const Element& element) {
    std::string text = configured.objects[element.object].name;
    for (const std::int64_t subscript : subscripts_of(configured, element))
        text += fmt::format("[{}]", subscript);
    return text;
}

std::size_t Configurer::new_object(std::string name, const Type* type, const Place& place) {
    if (count_of_elements(*type) > largest_object)
        reporter_.give_up(
            at(place), fmt::format("the array is too large: a configuration has at most {} elements", largest_object));
    configured_.objects.push_back({std::move(name), type, place});
    return configured_.objects.size() - 1;
}

Configurer::Selection Configurer::slice(const Selection& whole, std::size_t first, std::size_t count) const {
    Selection part;
    for (const Range& range : whole) {
        const std::size_t begin = std::min(first, range.count), taken = std::min(count, range.count - begin);
        if (taken > 0)
            part.push_back({range.object, range.first + begin, taken});
        first -= begin;
        count -= taken;
    }
    return part;
}

/// Returns the elements that an expression such as `t[1]` names (a path); none if the path has an error. REQUIRES: the
/// checker has checked the path.
Configurer::Selection Configurer::selection_of(const Expression& path) {
    if (const auto* const use = std::get_if<NameUse>(&path.form)) {
        const auto found = selections_.find(use->meaning);
        return found == selections_.end() ? Selection{} : found->second;
    }
    if (const auto* const table = std::get_if<TableLiteral>(&path.form)) {
        Selection all;
        for (const Expression& each : table->elements)
            std::ranges::copy(selection_of(each), std::back_inserter(all));
        return all;
    }
    const auto* const subscript = std::get_if<Subscript>(&path.form);
    const auto* const segment = std::get_if<Segment>(&path.form);
    if ((!subscript && !segment) || !path.type || innermost(*path.type).kind == Type::Kind::mistaken)
        return {};
    const Expression* const from = subscript ? subscript->index.get() : segment->from.get();
    const std::int64_t first = !from ? 0 : from->constant ? from->constant->bits : -1;
    const std::size_t count = count_of_elements(*path.type);
    const std::size_t each = subscript ? count : count_of_elements(*path.type->element);
    if (first < 0) {
        checker_.report(from->at, "a subscript in a configuration must be a constant", "");
        return {};
    }
    return slice(selection_of(subscript ? *subscript->array : *segment->array), static_cast<std::size_t>(first) * each,
                 count);
}

bool Configurer::has_kind(const Expression& path, Type::Kind kind, const std::string& what) {
    const Type& type = innermost(*path.type);
    if (type.kind == kind)
        return true;
    if (type.kind != Type::Kind::mistaken)
        checker_.report(path.at, fmt::format("{} is expected, not {}", what, name_of(*path.type)), "");
    return false;
}

std::vector<Element> Configurer::elements(const Selection& selection, const Place& place) {
    std::vector<Element> all;
    for (const Range& range : selection)
        for (std::size_t i = 0; i < range.count; ++i) {
            count_step(place);
            all.push_back({range.object, range.first + i});
        }
    return all;
}

std::vector<Element> Configurer::elements(Expression& path, Type::Kind kind, const std::string& what) {
    checker_.check(path);
    return has_kind(path, kind, what) ? elements(selection_of(path), path.at) : std::vector<Element>{};
}

/// Returns the single element that a path names. If it does not name one element, reports an error, and returns
/// nothing.
std::optional<Element> Configurer::single(Expression& path, Type::Kind kind, const std::string& what) {
    checker_.check(path);
    if (!has_kind(path, kind, what))
        return std::nullopt;
    if (path.type->kind == Type::Kind::array) {
        checker_.report(path.at, fmt::format("{} is expected, not an array", what), "choose an element by a subscript");
        return std::nullopt;
    }
    const std::vector<Element> found = elements(selection_of(path), path.at);
    return found.size() == 1 ? std::optional(found.front()) : std::nullopt;
}

} // namespace placedpar::occam
