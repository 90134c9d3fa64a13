#include "netlist/elaborate/attributes.hpp"

#include "text/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar {

namespace {

constexpr std::int64_t largest_address_space = std::int64_t{1} << 32;
constexpr std::int64_t highest_frequency = 1'000'000'000;

/// Checks values of attributes one by one.
class Checker {
public:
    Checker(const Setting& setting, Reporter& reporter) : setting_(setting), reporter_(reporter) {}

    std::int64_t size(std::int64_t least, std::int64_t most, const std::string& unit) const {
        return within(integer().value, least, most, unit);
    }
    /// 20M is twenty million here: the suffixes of a frequency are decimal.
    std::int64_t frequency(const std::string& unit) const {
        return within(integer().decimal, 1, highest_frequency, unit);
    }
    double metres() const {
        const auto& value = setting_.value;
        if (!value.is_number())
            wrong_type("a number");
        auto length = value.real() != nullptr ? *value.real() : static_cast<double>(value.integer()->value);
        if (!(length >= 0 && length <= 1000))
            illegal(shown(value), "it goes from 0 to 1000 metres");
        return length;
    }
    std::string text() const {
        if (setting_.value.text() == nullptr)
            wrong_type("a string");
        return *setting_.value.text();
    }
    Value any() const {
        if (const auto* integer = setting_.value.integer())
            return integer->value;
        if (const auto* real = setting_.value.real())
            return *real;
        return text();
    }
    [[noreturn]] void illegal(const std::string& value, const std::string& hint) const {
        reporter_.error(setting_.at, fmt::format("illegal value of the attribute \"{}\": {}", setting_.name, value),
                        hint);
        throw StatementRefused{};
    }

private:
    const Integer& integer() const {
        if (setting_.value.integer() == nullptr)
            wrong_type("an integer");
        return *setting_.value.integer();
    }
    std::int64_t within(std::int64_t value, std::int64_t least, std::int64_t most, const std::string& unit) const {
        if (value < least || value > most)
            illegal(fmt::format("{}", value), fmt::format("it goes from {} to {} {}", least, most, unit));
        return value;
    }
    [[noreturn]] void wrong_type(const std::string& wanted) const {
        reporter_.error(setting_.at,
                        fmt::format("wrong type for the attribute \"{}\": {} is {}", setting_.name,
                                    shown(setting_.value), type_name(setting_.value)),
                        "it takes " + wanted);
        throw StatementRefused{};
    }

    const Setting& setting_;
    Reporter& reporter_;
};

void flatten(Evaluator& evaluator, const Attribute& attribute, const std::string& prefix,
             std::vector<Setting>& result) {
    auto name = prefix + attribute.name;
    if (attribute.value)
        result.push_back({name, evaluator.evaluate(*attribute.value), attribute.at});
    for (const auto& member : attribute.group)
        flatten(evaluator, member, name + ".", result);
}

[[noreturn]] void refuse_attribute(const Setting& setting, const std::string& whose,
                                   const std::vector<std::string>& known, Reporter& reporter) {
    reporter.error(setting.at, fmt::format("{} has no attribute \"{}\"", whose, setting.name),
                   did_you_mean(setting.name, known));
    throw StatementRefused{};
}

void apply_type(NodeType& type, const Setting& setting, const Scopes& scopes, Reporter& reporter) {
    Checker check(setting, reporter);
    auto name = check.text();
    const auto* symbol = scopes.find(name);
    const auto* known = symbol == nullptr ? nullptr : std::get_if<NodeType>(&symbol->meaning);
    if (known == nullptr || known->preset.kind != NodeKind::processor || known->needs_type) {
        auto guess = did_you_mean(name, predefined_node_type_names());
        check.illegal(fmt::format("\"{}\"", name),
                      guess.empty() ? "it names a type of processor, such as \"T800\"" : guess);
    }
    type = *known;
}

const std::vector<std::string>& known_node_attributes() {
    static const std::vector<std::string> names{"type",        "memory",   "clock",     "linkspeed",
                                                "channelcall", "reserved", "routecost", "linkquota",
                                                "tolerance",   "nodebug",  "noprofile", "pagesize"};
    return names;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

} // namespace

std::vector<Setting> evaluate_attributes(Evaluator& evaluator, Reporter& reporter,
                                         const std::vector<Attribute>& attributes) {
    std::vector<Setting> result;
    for (const auto& attribute : attributes)
        flatten(evaluator, attribute, "", result);
    std::map<std::string, Location> first;
    for (const auto& setting : result) {
        auto [known, is_new] = first.emplace(setting.name, setting.at);
        if (is_new)
            continue;
        reporter.error(setting.at, fmt::format("the attribute \"{}\" is given twice", setting.name), "",
                       {{"first given here", known->second}});
        throw StatementRefused{};
    }
    return result;
}

void apply_node_attributes(NodeType& type, const std::vector<Setting>& settings, const Scopes& scopes,
                           Reporter& reporter) {
    for (const auto& setting : settings)
        if (setting.name == "type" && type.needs_type)
            apply_type(type, setting, scopes, reporter);
    for (const auto& setting : settings) {
        Checker check(setting, reporter);
        auto& preset = type.preset;
        if (preset.kind == NodeKind::edge || preset.kind == NodeKind::c004)
            refuse_attribute(setting, preset.kind == NodeKind::edge ? "an edge" : "a C004", {}, reporter);
        if (setting.name == "memory")
            preset.memory_bytes = check.size(1, largest_address_space, "bytes");
        else if (setting.name == "clock")
            preset.clock_hz = check.frequency("Hz");
        else if (setting.name == "linkspeed")
            preset.link_bits_per_second = check.frequency("bit/s");
        else if (setting.name == "channelcall")
            preset.channel_call_cycles = check.size(0, highest_frequency, "cycles");
        else if (setting.name == "type" && preset.type != check.text() && !type.needs_type)
            check.illegal(fmt::format("\"{}\"", check.text()), "the type is " + preset.type + " already");
        else if (!contains(known_node_attributes(), setting.name.substr(0, setting.name.find('.'))))
            refuse_attribute(setting, "a node", known_node_attributes(), reporter);
        else if (setting.name != "type")
            preset.other[setting.name] = check.any();
    }
}

void apply_connection_attributes(DraftConnection& connection, const std::vector<Setting>& settings,
                                 Reporter& reporter) {
    for (const auto& setting : settings) {
        Checker check(setting, reporter);
        if (setting.name == "linkspeed") {
            connection.bits_per_second = check.frequency("bit/s");
        } else if (setting.name == "length") {
            connection.metres = check.metres();
        } else if (setting.name == "level") {
            reporter.error(setting.at, "the attribute \"level\" belongs to a connection to a bus",
                           "the bus is not there yet");
            throw StatementRefused{};
        } else {
            refuse_attribute(setting, "a connection", {"linkspeed", "length", "level"}, reporter);
        }
    }
}

const std::vector<std::string>& process_attribute_names() {
    static const std::vector<std::string> names{"stacksize", "heapsize",  "priority", "interface",
                                                "order",     "location",  "reserved", "routecost",
                                                "linkquota", "tolerance", "nodebug",  "noprofile"};
    return names;
}

bool is_process_attribute(const std::string& name) {
    return contains(process_attribute_names(), name.substr(0, name.find('.')));
}

void apply_process_attribute(DraftProcess& process, const Setting& setting, Reporter& reporter) {
    Checker check(setting, reporter);
    if (setting.name == "stacksize" || setting.name == "heapsize") {
        process.other[setting.name] = check.size(0, largest_address_space, "bytes");
    } else if (setting.name == "priority") {
        const auto* integer = setting.value.integer();
        if (integer == nullptr || (integer->value != 0 && integer->value != 1))
            check.illegal(shown(setting.value), "a priority is HIGH or LOW");
        process.high_priority = integer->value == 1;
    } else {
        process.other[setting.name] = check.any();
    }
}

} // namespace placedpar
