#include "netlist/kinds/fault_kinds.hpp"

#include "netlist/kinds/description.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <utility>

namespace placedpar {

namespace {

using description::integer;

constexpr double longest = 9e15; ///< in ns; a little less than the largest time that a run can reach

AttributeDescription direction() {
    return {.value =
                description::text("direction", {.by_default = "both", .choices = {"both", "out", "in"}},
                                  "out: the direction away from the link that the fault names, or, for a connection, "
                                  "away from the end that connect names first; in: the opposite direction")};
}

AttributeDescription factor() {
    return {.value = integer("factor", {.least = 1, .most = 1e6}, "the bit rate is divided by this factor"),
            .decimal_suffixes = true};
}

AttributeDescription moment(const char* name, const char* about) {
    return {.value = integer(name, {.unit = "ns", .by_default = 0, .least = 0, .most = longest}, about),
            .decimal_suffixes = true};
}

} // namespace

AttributeDescription fault_begins() { return moment("from", "time at which the fault begins, such as 20ms"); }
AttributeDescription fault_ends() { return moment("until", "time at which the fault ends; 0: it never ends"); }

AttributeDescription fault_must_end() {
    return {.value = integer("until", {.unit = "ns", .least = 1, .most = longest}, "time at which the fault ends"),
            .decimal_suffixes = true};
}

const std::vector<FaultKind>& link_faults() {
    static const std::vector<FaultKind> kinds{
        {.name = "silent",
         .about = "bytes and acknowledges whose transmission begins during the fault are lost",
         .attributes = {fault_begins(), fault_ends(), direction()}},
        {.name = "loses_acknowledge",
         .about = "the first acknowledge whose transmission begins at this time or later is lost",
         .attributes = {fault_begins(), direction()}},
        {.name = "slow",
         .about = "the link is slower: each bit lasts longer, in both directions",
         .attributes = {fault_begins(), fault_ends(), factor()}}};
    return kinds;
}

FaultKind leaves_the_bus() {
    return {.name = "absent",
            .about = "the device does not respond on the bus: each access ends in a bus error",
            .attributes = {fault_begins(), fault_ends()}};
}

bool leaves_the_bus(const Fault& fault) { return fault.link < 0 && fault.kind == "absent"; }

Time begin_of(const Fault& fault) { return std::chrono::nanoseconds{fault.integer("from")}; }

Time end_of(const Fault& fault) {
    bool passes = fault.attributes.contains("until") && fault.integer("until") > 0;
    return passes ? Time{std::chrono::nanoseconds{fault.integer("until")}} : Time::max();
}

std::string print_nanoseconds(std::int64_t time) {
    constexpr std::pair<std::int64_t, const char*> units[] = {{1'000'000'000, "s"}, {1'000'000, "ms"}, {1000, "us"}};
    for (const auto& [unit, name] : units)
        if (time > 0 && time % unit == 0)
            return fmt::format("{}{}", time / unit, name);
    return fmt::format("{}ns", time);
}

namespace {

const FaultKind& kind_of(const Fault& fault, const std::vector<Node>& nodes) {
    const auto& kinds = fault.link < 0 ? nodes[fault.node].kind->faults : link_faults();
    return *std::ranges::find(kinds, fault.kind, &FaultKind::name);
}

std::string print_attribute(const AttributeDescription& attribute, const Value& value) {
    if (const auto* text = std::get_if<std::string>(&value))
        return fmt::format("{} = \"{}\"", attribute.value.name, *text);
    auto number = std::get<std::int64_t>(value);
    return fmt::format("{} = {}", attribute.value.name,
                       attribute.value.unit == "ns" ? print_nanoseconds(number) : fmt::format("{}", number));
}

/// Returns the time with a blank before its unit: "20 ms".
std::string print_moment(Time moment) {
    std::string text = print_nanoseconds(std::chrono::duration_cast<std::chrono::nanoseconds>(moment).count());
    return text.insert(text.find_first_not_of("0123456789"), " ");
}

} // namespace

std::string print_fault_shortly(const Fault& fault) {
    std::string text = fault.kind;
    std::ranges::replace(text, '_', ' ');
    if (fault.attributes.contains("factor"))
        text += fmt::format(", {} times,", fault.integer("factor"));
    if (begin_of(fault) > Time{0})
        text += " from " + print_moment(begin_of(fault));
    if (end_of(fault) < Time::max())
        text += " until " + print_moment(end_of(fault));
    return text.ends_with(',') ? text.substr(0, text.size() - 1) : text;
}

bool strikes(const Fault& fault, const LinkConnection& wire) {
    LinkEnd end{fault.node, fault.link};
    return fault.link >= 0 && wire.bits_per_second > 0 && (wire.a == end || wire.b == end);
}

std::string print_fault(const Fault& fault, const std::vector<Node>& nodes) {
    std::vector<std::string> said;
    for (const auto& attribute : kind_of(fault, nodes).attributes)
        if (const auto& value = fault.attributes.at(attribute.value.name); value != attribute.value.default_value)
            said.push_back(print_attribute(attribute, value));
    std::string what = fault.link < 0 ? nodes[fault.node].name : link_name(nodes, {fault.node, fault.link});
    std::string attributes = said.empty() ? "" : fmt::format(" ({})", fmt::join(said, ", "));
    return fmt::format("{} {}{}", what, fault.kind, attributes);
}

} // namespace placedpar
