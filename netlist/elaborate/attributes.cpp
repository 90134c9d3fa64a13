#include "netlist/elaborate/attributes.hpp"

#include "netlist/elaborate/attribute_value.hpp"
#include "netlist/kinds/description.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace placedpar {

namespace {

void flatten(Evaluator& evaluator, const Attribute& attribute, const std::string& prefix,
             std::vector<Setting>& result) {
    auto name = prefix + attribute.name;
    if (attribute.value)
        result.push_back({name, evaluator.evaluate(*attribute.value), attribute.at});
    for (const auto& member : attribute.group)
        flatten(evaluator, member, name + ".", result);
}

void refuse_repeated(const std::vector<Setting>& settings, Reporter& reporter) {
    std::map<std::string, Location> first;
    for (const auto& setting : settings) {
        auto [known, is_new] = first.emplace(setting.name, setting.at);
        if (is_new)
            continue;
        reporter.error(setting.at, fmt::format("two values are given for \"{}\"", setting.name), "",
                       {first_given(known->second)});
        throw StatementRefused{};
    }
}

AttributeDescription process_memory(const std::string& name) {
    return {.value = description::integer(name, {.unit = "bytes", .least = 0, .most = 4294967296.0},
                                          "kept, but has no effect")};
}

void apply_connection_attribute(DraftConnection& connection, const Setting& setting, Reporter& reporter) {
    AttributeValue value(setting, reporter);
    const auto& known = connection_attributes();
    auto attribute = std::ranges::find(known, setting.name, [](const auto& each) { return each.value.name; });
    if (attribute == known.end()) {
        std::vector<std::string> names;
        std::ranges::transform(known, std::back_inserter(names), [](const auto& each) { return each.value.name; });
        value.refuse_name("a connection", names);
    }
    Value taken = value.as(*attribute);
    if (setting.name == "linkspeed")
        connection.bits_per_second = std::get<std::int64_t>(taken);
    else if (setting.name == "length")
        connection.metres = std::get<double>(taken);
    else if (setting.name == "level")
        connection.level = static_cast<int>(std::get<std::int64_t>(taken));
    else
        connection.release = std::get<std::string>(taken);
}

bool is_high(const Setting& setting, const AttributeValue& value) {
    const auto* integer = setting.value.integer();
    if (integer == nullptr || (integer->value != 0 && integer->value != 1))
        value.illegal(shown(setting.value), "expected HIGH (0) or LOW (1)");
    return integer->value == 0;
}

} // namespace

SecondPlace first_given(const Location& at) { return {fmt::format("given first at line {}", at.line), at}; }

void refuse_given_twice(Reporter& reporter, const Setting& second, std::string_view what, const std::string& whose,
                        const Location& first) {
    reporter.error(second.at, fmt::format("the {} \"{}\" of \"{}\" is given twice", what, second.name, whose), "",
                   {first_given(first)});
    throw StatementRefused{};
}

std::vector<Setting> evaluate_attributes(Evaluator& evaluator, Reporter& reporter,
                                         const std::vector<Attribute>& attributes) {
    std::vector<Setting> result;
    for (const auto& attribute : attributes)
        flatten(evaluator, attribute, "", result);
    refuse_repeated(result, reporter);
    return result;
}

const std::vector<AttributeDescription>& connection_attributes() {
    using namespace description;
    static const std::vector<AttributeDescription> attributes{
        {.value = integer("linkspeed", {.unit = "bit/s", .least = 1, .most = 1e9},
                          "bit rate of the wire, in both directions"),
         .decimal_suffixes = true},
        {.value = real("length", {.unit = "metres", .least = 0, .most = 1000}, "length of the wire")},
        {.value = integer("level", {.least = 0, .most = 3}, "level at which the master requests the bus")},
        {.value = text("release", {.choices = {"RWD", "ROR"}},
                       "when the master releases the bus: RWD after each block of words, ROR when another master "
                       "requests the bus")}};
    return attributes;
}

void apply_connection_attributes(DraftConnection& connection, const std::vector<Setting>& settings,
                                 Reporter& reporter) {
    for (const auto& setting : settings)
        apply_connection_attribute(connection, setting, reporter);
}

const std::vector<std::string>& process_attribute_names() {
    static const std::vector<std::string> names{"stacksize", "heapsize",  "priority", "interface",
                                                "order",     "location",  "reserved", "routecost",
                                                "linkquota", "tolerance", "nodebug",  "noprofile"};
    return names;
}

bool is_process_attribute(const std::string& name) { return names_attribute(process_attribute_names(), name); }

void apply_process_attribute(DraftProcess& process, const Setting& setting, Reporter& reporter) {
    AttributeValue value(setting, reporter);
    if (setting.name == "priority")
        process.high_priority = is_high(setting, value);
    else if (setting.name == "stacksize" || setting.name == "heapsize")
        process.other[setting.name] = value.as(process_memory(setting.name));
    else
        process.other[setting.name] = value.any();
}

} // namespace placedpar
