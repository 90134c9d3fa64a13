#include "netlist/elaborate/elaborator.hpp"
#include "netlist/elaborate/option_statements.hpp"
#include "netlist/language/lexer.hpp"
#include "text/nearest.hpp"
#include "text/program_name.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar {

namespace {

bool is_bare(const Reference& target) { return target.subscripts.empty() && target.field.empty(); }

/// Returns true for an integer that may be a character constant: the code of a printable character.
bool is_character(const Constant& constant) {
    const auto* code = constant.integer();
    return code != nullptr && code->value > ' ' && code->value <= '~';
}

/// If the user typed a list or a range of values, returns a hint that names the command `sweep`, which tries several
/// values; otherwise "".
std::string hint_at_sweep(const SetStatement& set) {
    const bool lists = set.typed.find(',') != std::string::npos || set.typed.find("..") != std::string::npos;
    return !lists || set.typed.find('(') != std::string::npos
               ? ""
               : fmt::format("--set takes one value; to try several: {} sweep FILE {}", program_name(),
                             set.value_at.file->text());
}

Constant constant_of(const Value& value) {
    if (const auto* integer = std::get_if<std::int64_t>(&value))
        return integer_constant(*integer);
    if (const auto* real = std::get_if<double>(&value))
        return {*real};
    return {std::get<std::string>(value)};
}

} // namespace

Value Elaborator::choose_val(const std::string& name, const Value& original, const Location& at) {
    Constant chosen = constant_of(original);
    attempt([&] { chosen = overridden(name, chosen); });
    if (!scopes_.find(name))
        scopes_.declare_predefined(name, {chosen, at});
    if (const Integer* integer = chosen.integer())
        return std::holds_alternative<double>(original) ? Value(as_real(chosen)) : Value(integer->value);
    return chosen.real() ? Value(*chosen.real()) : Value(*chosen.text());
}

Draft Elaborator::take() {
    for (auto& [place, set] : reached_)
        if (!set.elements.empty())
            draft_.set.push_back(std::move(set));
    return std::move(draft_);
}

/// Evaluates the value of an option. If a string is wanted, a text without quotes is accepted as it is.
Constant Elaborator::value_of(const SetStatement& set, bool text_wanted, const std::string& what_it_takes) {
    Reporter here;
    std::optional<Constant> value;
    if (set.problems.empty())
        attempt([&] { value = Evaluator(scopes_, here).evaluate(*set.value); });
    const bool is_unquoted = text_wanted && !set.typed.starts_with('"') && !(value && value->text() != nullptr);
    if (is_unquoted && set.typed.size() > longest_string)
        refuse(set.value_at, fmt::format("the string is too long: at most {} characters are allowed", longest_string));
    if (is_unquoted)
        return {set.typed};
    if (value)
        return *value;
    if (set.typed.empty())
        refuse(set.value_at, "the value is missing", what_it_takes);
    std::vector<Diagnostic> problems = set.problems.empty() ? here.take() : set.problems;
    if (const auto* use = set.value ? std::get_if<NameUse>(&set.value->form) : nullptr)
        problems.front().hint = did_you_mean(use->name, names_of_vals()); // suggest vals only, not FALSE for "fast"
    if (const std::string hint = hint_at_sweep(set); !hint.empty())
        problems.front().hint = hint;
    if (problems.front().hint.empty())
        problems.front().hint = what_it_takes;
    for (const Diagnostic& problem : problems)
        reporter_.error(problem.location, problem.message, problem.hint, problem.others);
    throw StatementRefused{};
}

/// Returns the value that an option gives to a constant (`val`), or the original value if there is no such option.
/// Options can set only vals outside of blocks.
Constant Elaborator::overridden(const std::string& name, const Constant& original) {
    if (!scopes_.outermost()) {
        vals_in_blocks_.insert(name);
        return original;
    }
    vals_.emplace_back(name, original);
    Constant result = original;
    for (const Statement& each : overrides_)
        if (const auto& set = std::get<SetStatement>(each.form); is_bare(set.target) && set.target.name == name)
            result = override_val(set, original);
    return result;
}

Constant Elaborator::override_val(const SetStatement& set, const Constant& original) {
    const std::string& name = set.target.name;
    if (auto [first, is_new] = overridden_vals_.emplace(name, set.target.at); !is_new)
        refuse(set.target.at, fmt::format("the val \"{}\" is set twice", name), "",
               {{"set first here", first->second}});
    auto given = fmt::format("in the netlist its value is {}, {}{}", shown(original), type_name(original),
                             set.typed.size() == 1 && is_character(original) ? "; a character is written 'c'" : "");
    Constant value = value_of(set, original.text() != nullptr, given);
    if (value.value.index() != original.value.index() && !(value.integer() != nullptr && original.real() != nullptr))
        refuse(set.value_at,
               fmt::format("wrong type for the val \"{}\": {} is {}", name, shown(value), type_name(value)), given);
    draft_.set.push_back({name, set.typed, {}});
    reporter_.add_option(name, set.target.at);
    return value;
}

/// Executes an option: sets an attribute or parameter of the named nodes, connections or processes. An option for a
/// `val` has already taken effect where the `val` is declared.
void Elaborator::perform(const SetStatement& form, const Location&) {
    const Reference& target = form.target;
    if (is_bare(target) && overridden_vals_.contains(target.name))
        return;
    if (!target.field_subscripts.empty())
        refuse(target.field_at, fmt::format("\"{}\" can be set only as a whole, not by element", target.field));
    const bool of_all = target.field.empty();
    const std::string name = element_name(target.name, subscripts(target.subscripts));
    const std::string& member = of_all ? name : target.field;
    std::vector<Settable> named = elements_named(of_all ? "" : name, member);
    SetByOption& reached = reached_[form.place];
    reached = {of_all ? name : name + "." + member, form.typed, {}};
    bool has_it = false;
    for (const Settable& each : named)
        if (each.has(member, of_all)) {
            has_it = true;
            if (set_once(form, member, each))
                reached.elements.push_back(each.name);
        }
    if (!has_it)
        refuse_set(form, name, named);
}

/// Returns the element of that name, or the elements of the array of that name; all elements if the name is empty. If
/// the option may refer to wires or attachments to buses that have no name, gives them names first.
std::vector<Settable> Elaborator::elements_named(const std::string& name, const std::string& member) {
    auto find_them = [&] {
        std::vector<Settable> all = settable_elements(draft_, catalogue_);
        std::erase_if(all, [&](const Settable& each) {
            return !name.empty() && each.name != name && !each.name.starts_with(name + "[");
        });
        return all;
    };
    std::vector<Settable> found = find_them();
    if (name.empty() ? member == "length" : found.empty() && name.starts_with("wire"))
        name_wires();
    else if (name.empty() ? member == "level" || member == "release" : found.empty() && name.starts_with("attachment"))
        name_attachments();
    else
        return found;
    return find_them();
}

/// Gives each wire without a name a connection, wire[0], wire[1] ..., so that options can set its attributes.
void Elaborator::name_wires() {
    name_connections(draft_.wires, "wire", [](const DraftWire&) { return true; });
}

/// Gives each attachment of a master to a bus that has no name a connection, attachment[0], attachment[1] ...
void Elaborator::name_attachments() {
    name_connections(draft_.attachments, "attachment",
                     [&](const DraftAttachment& each) { return draft_.nodes[each.node].kind->is_master(); });
}

template <class Things, class IsMeant>
void Elaborator::name_connections(Things& things, const std::string& wanted, IsMeant is_meant) {
    const std::string name = claim_name(wanted);
    std::int64_t number = 0;
    for (auto& each : things)
        if (each.connection == nowhere && is_meant(each)) {
            each.connection = draft_.connections.size();
            draft_.connections.push_back({element_name(name, {number++}), each.at, {}, {}, each.at, {}});
        }
}

/// Records that the option sets the attribute or parameter. Returns false if an option with a more precise target has
/// already set it.
bool Elaborator::set_once(const SetStatement& set, const std::string& member, const Settable& element) {
    auto [first, is_new] = set_.emplace(std::pair(element.name, member), &set);
    if (!is_new && first->second->precision() > set.precision())
        return false;
    if (!is_new)
        refuse(set.target.at, fmt::format("\"{}\" of \"{}\" is set twice", member, element.name), "",
               {{"set first here", first->second->target.at}});
    const SettableMember* known = element.member(member);
    const SettableMember taking = known != nullptr ? *known : SettableMember{member};
    element.set({member, value_of(set, taking.takes_text, taking.what_it_takes()), set.value_at}, reporter_);
    return true;
}

} // namespace placedpar
