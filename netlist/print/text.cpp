#include "netlist/print/text.hpp"

#include "netlist/kinds/device_kind.hpp"
#include "netlist/network/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <map>

namespace placedpar {

namespace {

std::string print_real(double value) {
    auto text = fmt::format("{}", value);
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string print_string(const std::string& text) {
    std::string result = "\"";
    for (char c : text) {
        if (c == '"' || c == '\\')
            result += std::string("\\") + c;
        else if (c == '\n')
            result += "\\n";
        else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
            result += fmt::format("\\{:03o}", static_cast<unsigned char>(c));
        else
            result += c;
    }
    return result + "\"";
}

void enlarge(std::vector<std::int64_t>& dimensions, const std::vector<std::int64_t>& subscripts) {
    dimensions.resize(std::max(dimensions.size(), subscripts.size()), 0);
    for (std::size_t i = 0; i < subscripts.size(); ++i)
        dimensions[i] = std::max(dimensions[i], subscripts[i] + 1);
}

std::string declarator(std::string_view base, const std::vector<std::int64_t>& dimensions) {
    std::string result(base);
    for (auto size : dimensions)
        result += fmt::format("[{}]", size);
    return result;
}

} // namespace

std::string print_constant(const Value& value) {
    if (const auto* integer = std::get_if<std::int64_t>(&value)) {
        // the absolute value of this number does not fit into a signed 64-bit integer
        if (*integer == std::numeric_limits<std::int64_t>::min())
            return fmt::format("({} - 1)", *integer + 1);
        return fmt::format("{}", *integer);
    }
    if (const auto* real = std::get_if<double>(&value))
        return print_real(*real);
    return print_string(std::get<std::string>(value));
}

std::string print_entry(std::string_view name, const Value& value) {
    return fmt::format("{} = {}", name, print_constant(value));
}

std::vector<std::string> print_attributes(const Node& node, const Node* first) {
    std::vector<std::string> entries;
    for (const auto& attribute : node.kind->attributes) {
        const std::string& name = attribute.value.name;
        const auto& value = node.attributes.at(name);
        if (value != (first ? first->attributes.at(name) : attribute.value.default_value))
            entries.push_back(print_entry(name, value));
    }
    for (const auto& [name, value] : node.other)
        if (!first || !first->other.contains(name) || first->other.at(name) != value)
            entries.push_back(print_entry(name, value));
    return entries;
}

std::vector<ElementRange> element_ranges(std::size_t count, const std::function<std::string_view(std::size_t)>& name) {
    std::vector<ElementRange> ranges;
    std::vector<std::int64_t> dimensions;
    for (std::size_t i = 0; i < count; ++i) {
        auto base = base_name(name(i));
        if (ranges.empty() || ranges.back().base != base) {
            ranges.push_back({"", std::string(base), i, 0});
            dimensions.clear();
        }
        enlarge(dimensions, subscripts_of(name(i)));
        ++ranges.back().count;
        if (i + 1 == count || base_name(name(i + 1)) != base)
            ranges.back().declarator = declarator(base, dimensions);
    }
    return ranges;
}

std::vector<std::string> declarators_of(const std::vector<std::string>& names) {
    std::vector<std::string> order;
    std::map<std::string, std::vector<std::int64_t>, std::less<>> dimensions;
    for (const auto& name : names) {
        std::string base(base_name(name));
        if (!dimensions.contains(base))
            order.push_back(base);
        enlarge(dimensions[base], subscripts_of(name));
    }
    for (auto& base : order)
        base = declarator(base, dimensions[base]);
    return order;
}

std::string print_list(const std::vector<std::string>& entries) {
    if (entries.empty())
        return "";
    auto one_line = fmt::format("({})", fmt::join(entries, ", "));
    return one_line.size() < 90 ? one_line : fmt::format("({})", fmt::join(entries, ",\n    "));
}

bool is_used_by_code(const Network& network, const LinkConnection& wire) {
    return network.nodes[wire.a.node].runs_own_code || network.nodes[wire.b.node].runs_own_code;
}

std::string print_drawn_facts(const Node& node) {
    std::string text;
    for (const auto& attribute : node.kind->attributes)
        if (auto fact = attribute.drawn ? attribute.drawn(node.attributes.at(attribute.value.name)) : ""; !fact.empty())
            text += ", " + fact;
    return text;
}

std::string print_boot(const Node& node) {
    if (node.boot_file.empty())
        return "boots over its links";
    return "boots " + std::filesystem::path(node.boot_file).filename().string();
}

} // namespace placedpar
