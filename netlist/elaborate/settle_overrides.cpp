#include "netlist/elaborate/elaborator.hpp"

#include "netlist/network/names.hpp"
#include "text/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace placedpar {

namespace {

bool is_bare(const Reference& target) { return target.subscripts.empty() && target.field.empty(); }

/// Or a number that is the code of one.
bool is_character(const Constant& constant) {
    const auto* code = constant.integer();
    return code != nullptr && code->value > ' ' && code->value <= '~';
}

} // namespace

void Elaborator::read_overrides(const Overrides& overrides) {
    for (const auto& option : overrides)
        attempt([&] { overrides_.push_back(read_override(option.first, option.second, reporter_)); });
}

/// In the scopes as they are here.
void Elaborator::evaluate(Override& option) {
    Reporter here;
    if (option.value.problems.empty())
        attempt([&] { option.value.constant = Evaluator(scopes_, here).evaluate(*option.expression); });
    std::ranges::move(here.take(), std::back_inserter(option.value.problems));
    if (const auto* use = option.expression ? std::get_if<NameUse>(&option.expression->form) : nullptr;
        use != nullptr && !option.value.problems.empty())
        option.value.problems.front().hint = did_you_mean(use->name, names_of_vals()); // not FALSE, for "fast"
}

std::vector<std::string> Elaborator::names_of_vals() const {
    std::vector<std::string> names;
    for (const auto& [name, value] : draft_.vals)
        names.push_back(name);
    return names;
}

/// What an option gives to the val in place of the original; the original where none does. Only vals outside of blocks
/// are within an option's reach.
Constant Elaborator::overridden(const std::string& name, const Constant& original) {
    if (!scopes_.outermost()) {
        draft_.vals_in_blocks.insert(name);
        return original;
    }
    draft_.vals.emplace_back(name, original);
    Constant result = original;
    for (Override& option : overrides_)
        if (is_bare(option.target) && option.target.name == name)
            result = override_val(option, original);
    return result;
}

Constant Elaborator::override_val(Override& option, const Constant& original) {
    const std::string& name = option.target.name;
    if (auto [first, is_new] = overridden_vals_.emplace(name, option.target.at); !is_new)
        refuse(option.target.at, fmt::format("the val \"{}\" is set twice", name), "",
               {{"set first here", first->second}});
    evaluate(option);
    auto given =
        fmt::format("the netlist gives it {}, {}{}", shown(original), type_name(original),
                    option.value.typed.size() == 1 && is_character(original) ? "; a character is written 'c'" : "");
    Constant value = option.value.take(original.text() != nullptr, given, reporter_);
    if (value.value.index() != original.value.index() && !(value.integer() != nullptr && original.real() != nullptr))
        refuse(option.value.at,
               fmt::format("wrong type for the val \"{}\": {} is {}", name, shown(value), type_name(value)), given);
    draft_.set.push_back({name, option.value.typed, {}});
    reporter_.add_option(name, option.target.at);
    return value;
}

void Elaborator::settle_overrides() {
    for (Override& option : overrides_)
        if (!is_bare(option.target) || !overridden_vals_.contains(option.target.name))
            attempt([&] { draft_.overrides.push_back(settled(option)); });
}

void Elaborator::refuse_element(const Reference& target) {
    const std::string& name = target.name;
    auto val = std::ranges::find(draft_.vals, name, [](const auto& each) { return each.first; });
    if (val == draft_.vals.end())
        refuse(target.at, fmt::format("say what of \"{}\" to set", name),
               fmt::format("--set {}.NAME=VALUE", element_name(name, subscripts(target.subscripts))));
    const char* why = val->second.array() == nullptr ? "is no array" : "is set as a whole, not one of its elements";
    refuse(target.at, fmt::format("the val \"{}\" {}", name, why),
           fmt::format("the netlist gives it {}: --set '{}=...'", shown(val->second), name));
}

DraftOverride Elaborator::settled(Override& option) {
    const Reference& target = option.target;
    if (target.field.empty() && !target.subscripts.empty())
        refuse_element(target);
    if (!target.field_subscripts.empty())
        refuse(target.field_at, fmt::format("\"{}\" is set as a whole, not one of its elements", target.field));
    evaluate(option);
    if (target.field.empty())
        return {"", target.name, target.at, target.at, option.value};
    return {element_name(target.name, subscripts(target.subscripts)), target.field, target.at, target.field_at,
            option.value};
}

} // namespace placedpar
