#include "netlist/elaborate/elaborator.hpp"
#include "text/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace placedpar {

namespace {

std::string meant_by(const std::string& name, const std::vector<std::string>& known) {
    return name == "seed" ? "set the seed of a run with the option --seed N" : did_you_mean(name, known);
}

std::string_view base(const Settable& element) { return base_name(element.name); }

} // namespace

std::vector<std::string> Elaborator::names_of_vals() const {
    std::vector<std::string> names;
    std::ranges::transform(vals_, std::back_inserter(names), [](const auto& val) { return val.first; });
    return names;
}

/// Refuses an option `--set` if no node, connection or process has the attribute or parameter that it names.
void Elaborator::refuse_set(const SetStatement& set, const std::string& name, const std::vector<Settable>& named) {
    name_wires();
    name_attachments();
    const std::vector<Settable> all = settable_elements(draft_, catalogue_);
    const std::string& member = set.target.field;
    if (member.empty())
        refuse_name(set, name, all);
    if (named.empty())
        refuse_element(set, name, all);
    const Settable& first = named.front();
    std::string meant = meant_by(member, names_in(*first.members));
    refuse(set.target.field_at,
           fmt::format("the {} \"{}\" has no {} \"{}\"", first.noun(), name, first.noun_of_member(), member),
           meant.empty() ? hint_at_other(member, first, all) : meant, {{first.text_of_members(), {}}});
}

/// Returns a hint if the attribute belongs to the processor of the process, or to the connection of the master to its
/// bus; otherwise "".
std::string Elaborator::hint_at_other(const std::string& member, const Settable& element,
                                      const std::vector<Settable>& all) const {
    std::string other;
    for (const DraftAttachment& each : draft_.attachments)
        if (each.connection != nowhere && draft_.nodes[each.node].name == element.name)
            other = draft_.connections[each.connection].name;
    const auto* process = std::get_if<DraftProcess*>(&element.thing);
    if (process != nullptr && (*process)->node != nowhere)
        other = draft_.nodes[(*process)->node].name;
    const Settable* found = find_named(all, other);
    if (found == nullptr || !found->has(member))
        return "";
    auto which = process != nullptr ? fmt::format("the node of \"{}\"", element.name)
                                    : fmt::format("the connection of \"{}\" to its bus", element.name);
    return fmt::format("{} has this attribute: --set {}.{}=...", which, other, member);
}

/// Refuses an option whose name has no dot, if the name is not that of a `val`, an attribute or a parameter.
void Elaborator::refuse_name(const SetStatement& set, const std::string& name, const std::vector<Settable>& all) {
    const std::string& array = set.target.name;
    if (auto val = std::ranges::find(vals_, array, [](const auto& each) { return each.first; }); val != vals_.end())
        refuse(set.target.at,
               fmt::format("the val \"{}\" {}", array,
                           val->second.array() != nullptr ? "can be set only as a whole, not by element"
                                                          : "is not an array"),
               fmt::format("in the netlist its value is {}: --set '{}=...'", shown(val->second), array));
    if (auto element = std::ranges::find(all, array, base); element != all.end())
        refuse(set.target.at,
               fmt::format("\"{}\" is a {}: name the attribute or parameter to set", array, element->noun()),
               fmt::format("--set {}.NAME=VALUE", name), {{element->text_of_members(), {}}});
    if (vals_in_blocks_.contains(array))
        refuse(set.target.at, fmt::format("the val \"{}\" is declared in a block", array),
               "--set sets only vals outside of blocks");
    std::vector<std::string> known = names_of_vals();
    for (const Settable& each : all) {
        std::ranges::move(names_in(*each.members), std::back_inserter(known));
        known.emplace_back(base(each));
    }
    refuse(set.target.at, fmt::format("the netlist has no val, attribute or parameter \"{}\"", name),
           meant_by(name, known), what_can_be_set(vals_, all));
}

void Elaborator::refuse_element(const SetStatement& set, const std::string& name, const std::vector<Settable>& all) {
    const std::string& array = set.target.name;
    std::vector<std::string> names, elements;
    for (const Settable& each : all) {
        names.emplace_back(base(each));
        if (base(each) == array)
            elements.push_back(each.name);
    }
    if (elements.empty())
        refuse(set.target.at, fmt::format("the netlist has no node, connection or process \"{}\"", array),
               did_you_mean(array, names), what_can_be_set(vals_, all));
    if (elements.front() == array)
        refuse(set.target.at, fmt::format("\"{}\" is not an array", array),
               fmt::format("--set {}.{}=...", array, set.target.field));
    refuse(set.target.at, fmt::format("nothing has the name \"{}\"", name),
           fmt::format("the names are {}{}", elements.front(), elements.size() == 1 ? "" : " to " + elements.back()));
}

} // namespace placedpar
