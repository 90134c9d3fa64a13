#include "occam/check/checker.hpp"
#include "text/nearest.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <string_view>
#include <utility>

namespace placedpar::occam {

namespace {

constexpr std::array<std::string_view, 6> refused_names = {
    "KERNEL.RUN",          "LOAD.INPUT.CHANNEL",         "LOAD.INPUT.CHANNEL.VECTOR",
    "LOAD.OUTPUT.CHANNEL", "LOAD.OUTPUT.CHANNEL.VECTOR", "LOAD.BYTE.VECTOR"};

/// Returns the next expression toward the root of a path; null if this is the root.
const Expression* toward_root(const Expression& expression) {
    if (const auto* subscript = std::get_if<Subscript>(&expression.form))
        return subscript->array.get();
    const auto* segment = std::get_if<Segment>(&expression.form);
    return segment ? segment->array.get() : nullptr;
}

} // namespace

const Declaration* root_of(const Expression& expression) {
    if (const auto* use = std::get_if<NameUse>(&expression.form))
        return use->meaning;
    const Expression* const next = toward_root(expression);
    return next ? root_of(*next) : nullptr;
}

const Declaration* named_by(const Declaration& declaration) {
    if (const auto* abbreviation = std::get_if<Abbreviation>(&declaration.form))
        return abbreviation->is_value ? nullptr : root_of(abbreviation->value);
    const auto* retyping = std::get_if<Retyping>(&declaration.form);
    return retyping && !retyping->is_value ? root_of(retyping->value) : nullptr;
}

const Declaration* base_of(const Declaration* declaration) {
    while (const Declaration* const next = declaration ? named_by(*declaration) : nullptr)
        declaration = next;
    return declaration;
}

bool is_data(const Type& type) {
    const Type::Kind kind = innermost(type).kind;
    return kind == Type::Kind::basic || kind == Type::Kind::record || kind == Type::Kind::derived;
}

const Type& innermost(const Type& type) { return type.kind == Type::Kind::array ? innermost(*type.element) : type; }

bool fits(const Type& wanted, const Type& given) {
    if (&wanted == &given || wanted.kind == Type::Kind::mistaken || given.kind == Type::Kind::mistaken)
        return true;
    if (wanted.kind != Type::Kind::array || given.kind != Type::Kind::array)
        return false;
    return (!wanted.count || !given.count || *wanted.count == *given.count) && fits(*wanted.element, *given.element);
}

void Names::add(Declaration& declaration) {
    order_.push_back(&declaration);
    by_name_[declaration.name].push_back(&declaration);
}

Declaration* Names::find(const std::string& name) const {
    const auto found = by_name_.find(name);
    return found == by_name_.end() || found->second.empty() ? nullptr : found->second.back();
}

void Names::leave(std::size_t mark) {
    for (; order_.size() > mark; order_.pop_back())
        by_name_[order_.back()->name].pop_back();
}

std::vector<std::string> Names::all() const {
    std::vector<std::string> names;
    for (auto each = order_.rbegin(); each != order_.rend(); ++each)
        names.push_back((*each)->name);
    return names;
}

void Checker::report(const Place& place, std::string message, std::string hint, std::vector<SecondPlace> others) {
    reporter_.error(program_.location(place), std::move(message), std::move(hint), std::move(others));
}

void Checker::report(const Place& place, std::string message, std::string hint, const Declaration* other) {
    std::vector<SecondPlace> others;
    if (other && other->at.line > 0)
        others.push_back({"\"" + other->name + "\" is declared here", program_.location(other->at)});
    report(place, std::move(message), std::move(hint), std::move(others));
}

bool Checker::is_first(const Declaration* declaration, std::string mistake) {
    return mistakes_.emplace(declaration, std::move(mistake)).second;
}

Declaration* Checker::find(const std::string& name, const Place& place) {
    if (Declaration* const found = names_.find(name)) {
        used_.insert(found);
        note(place, *found);
        return found;
    }
    if (Declaration* const found = predefined(name))
        return found;
    if (reported_.insert(name).second)
        report_unknown(name, place);
    return nullptr;
}

void Checker::report_unknown(const std::string& name, const Place& place) {
    if (std::ranges::find(refused_names, name) != refused_names.end())
        return report(place, name + " is not supported: programs are loaded by the loader of this compiler", "");
    for (const Routine& routine : routines_) {
        if (routine.declaration && routine.declaration->name == name)
            return report(place, "\"" + name + "\" is used in its own body: occam 2 has no recursion",
                          "use a loop, or an array as a stack", routine.declaration);
    }
    for (auto list = pending_.rbegin(); list != pending_.rend(); ++list) {
        for (std::size_t i = list->next; i < list->list->size(); ++i) {
            if ((*list->list)[i]->name == name && !std::holds_alternative<Placement>((*list->list)[i]->form))
                return report(place, "\"" + name + "\" is used before its declaration",
                              "move the declaration before this line", (*list->list)[i].get());
        }
    }
    if (reporter_.keeps_more())
        report(place, unknown_name("name", name, names_.all(), "nothing with this name is declared here"));
    else
        report(place, "unknown name");
}

void Checker::add(Declaration& declaration) {
    depths_[&declaration] = routines_.size();
    names_.add(declaration);
    declared_.push_back(&declaration);
    note(declaration.at, declaration);
}

/// Records the meaning of a name. In a configuration, a replicated statement is visited several times; the name is then
/// recorded only once.
void Checker::note(const Place& place, const Declaration& meaning) {
    if (!program_.is_configuration || noted_.emplace(place.file, place.line, place.column).second)
        program_.resolved.push_back({place, &meaning});
}

} // namespace placedpar::occam
