#include "netlist/elaborate/attribute_value.hpp"
#include "netlist/elaborate/elaborator.hpp"
#include "netlist/kinds/fault_kinds.hpp"
#include "text/counted.hpp"
#include "text/nearest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace placedpar {

namespace {

std::vector<std::string> names_of_faults(const std::vector<FaultKind>& kinds) {
    std::vector<std::string> names;
    for (const FaultKind& kind : kinds)
        names.push_back(kind.name);
    return names;
}

std::vector<std::string> names_of_attributes(const FaultKind& kind) {
    std::vector<std::string> names;
    for (const auto& attribute : kind.attributes)
        names.push_back(attribute.value.name);
    return names;
}

Value checked_value(const FaultKind& kind, const Setting& setting, Reporter& reporter) {
    AttributeValue value(setting, reporter);
    const auto* attribute = kind.attribute(setting.name);
    if (attribute == nullptr)
        value.refuse_name(fmt::format("the fault \"{}\"", kind.name), names_of_attributes(kind));
    Value result = value.as(*attribute);
    const auto& choices = attribute->value.choices;
    if (const auto* text = std::get_if<std::string>(&result);
        text != nullptr && !choices.empty() && std::ranges::find(choices, *text) == choices.end())
        value.illegal(fmt::format("\"{}\"", *text), fmt::format("expected one of {}", fmt::join(choices, ", ")));
    return result;
}

} // namespace

/// Returns the fault with its kind and the failing link, connection or device, but without its attributes.
DraftFault Elaborator::failing(const FaultStatement& form) {
    if (form.what.name == "wire" &&
        scopes_.find("wire") == nullptr) // the name that options use for unnamed connections
        refuse(form.what.at, "only a connection that the netlist names can have a fault",
               "state one of its links, such as fault t[0].link[1] silent; or name the connection, as in "
               "connect t[0].link[1] to t[1].link[0] by cable;");
    auto found = find(form.what);
    DraftFault draft;
    draft.fault.kind = form.fault;
    draft.fault.stated = draft.at = form.what.at;
    if (found.category == Category::connection && form.what.field.empty()) {
        draft.connection = element(form.what, found);
        draft.fault.link = 0;
        return draft;
    }
    if (found.category != Category::node)
        refuse(form.what.at,
               fmt::format("\"{}\" cannot have a fault: only links, connections of links, and devices can",
                           form.what.name));
    draft.fault.node = element(form.what, found);
    const Node& node = draft_.nodes[draft.fault.node];
    if (form.what.field.empty() && node.kind->faults.empty())
        refuse(form.what.at, fmt::format("{} itself has no faults", node.kind->noun),
               node.kind->links == LinkRole::ends
                   ? fmt::format("its links can have faults: fault {}.link[0] silent;", node.name)
                   : "");
    if (!form.what.field.empty())
        draft.fault.link = link_end(form.what, found).link;
    return draft;
}

void Elaborator::perform(const FaultStatement& form, const Location& at) {
    count_things(1, at);
    DraftFault draft = failing(form);
    bool of_link = draft.fault.link >= 0;
    const auto& kinds = of_link ? link_faults() : draft_.nodes[draft.fault.node].kind->faults;
    auto kind = std::ranges::find(kinds, form.fault, &FaultKind::name);
    if (kind == kinds.end()) {
        auto known = names_of_faults(kinds);
        std::string guess = did_you_mean(form.fault, known);
        refuse(form.fault_at,
               fmt::format("{} has no fault \"{}\"", of_link ? "a link" : draft_.nodes[draft.fault.node].kind->noun,
                           form.fault),
               guess.empty() ? fmt::format("its faults are {}", fmt::join(known, ", ")) : guess);
    }
    for (const auto& attribute : kind->attributes)
        if (attribute.value.default_value)
            draft.fault.attributes[attribute.value.name] = *attribute.value.default_value;
    auto settings = evaluate_attributes(evaluator_, reporter_, form.attributes);
    for (const Setting& setting : settings)
        draft.fault.attributes[setting.name] = checked_value(*kind, setting, reporter_);
    for (const Setting& setting : settings)
        if (setting.name == "until" && end_of(draft.fault) <= begin_of(draft.fault))
            refuse(setting.at, "the fault ends before it begins",
                   fmt::format("the fault begins at {}", print_nanoseconds(draft.fault.integer("from"))));
    for (const auto& attribute : kind->attributes)
        if (!draft.fault.attributes.contains(attribute.value.name))
            refuse(form.fault_at,
                   fmt::format("the fault \"{}\" needs the attribute \"{}\"", form.fault, attribute.value.name),
                   attribute.value.about);
    draft_.faults.push_back(std::move(draft));
}

} // namespace placedpar
