#include "netlist/elaborate/declared_type.hpp"

#include "netlist/network/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace placedpar {

namespace {

struct IntegerRange {
    std::string_view type;
    const char* article;
    std::int64_t least, most;
};

constexpr std::array integer_ranges{
    IntegerRange{.type = "char", .article = "a", .least = -128, .most = 255},
    IntegerRange{.type = "short", .article = "a", .least = -32768, .most = 32767},
    IntegerRange{.type = "int", .article = "an", .least = -2147483648LL, .most = 2147483647},
    IntegerRange{.type = "unsigned", .article = "an", .least = 0, .most = 4294967295LL}};

constexpr double largest_float = 3.4028234663852886e38;

bool is_text(const ParameterDeclaration& parameter) {
    return parameter.type == "char" && !parameter.dimensions.empty();
}

std::string out_of_range(const ParameterDeclaration& parameter, const std::string& number) {
    return fmt::format("the parameter \"{}\" is out of range: {}", parameter.name, number);
}

std::optional<Misfit> integer_misfit(const ParameterDeclaration& parameter, std::int64_t number) {
    const auto* range = std::ranges::find(integer_ranges, parameter.type, &IntegerRange::type);
    if (range == integer_ranges.end() || (number >= range->least && number <= range->most))
        return std::nullopt;
    return Misfit{out_of_range(parameter, fmt::format("{}", number)),
                  fmt::format("{} {} ranges from {} to {}", range->article, range->type, range->least, range->most)};
}

std::optional<Misfit> real_misfit(const ParameterDeclaration& parameter, double number) {
    if (parameter.type != "float" || std::abs(number) <= largest_float)
        return std::nullopt;
    return Misfit{out_of_range(parameter, fmt::format("{}", number)),
                  "a float is at most 3.4e38; declare a double for greater values"};
}

std::optional<Misfit> text_misfit(const ParameterDeclaration& parameter, const std::string& text) {
    if (!is_text(parameter) || static_cast<std::int64_t>(text.size()) <= parameter.dimensions.back())
        return std::nullopt;
    return Misfit{
        fmt::format("the string is too long for the parameter \"{}\": it has {} characters", parameter.name,
                    text.size()),
        fmt::format("{} holds at most {} characters", declaration_of(parameter), parameter.dimensions.back())};
}

} // namespace

ParameterType element_type(const ParameterDeclaration& parameter) {
    if (is_text(parameter))
        return ParameterType::text;
    return parameter.is_real() ? ParameterType::real : ParameterType::integer;
}

std::size_t element_dimensions(const ParameterDeclaration& parameter) {
    return parameter.dimensions.size() - (is_text(parameter) ? 1 : 0);
}

std::optional<Misfit> misfit(const ParameterDeclaration& parameter, const Value& value) {
    if (const auto* integer = std::get_if<std::int64_t>(&value))
        return integer_misfit(parameter, *integer);
    if (const auto* real = std::get_if<double>(&value))
        return real_misfit(parameter, *real);
    return text_misfit(parameter, std::get<std::string>(value));
}

std::string declaration_of(const ParameterDeclaration& parameter) {
    return parameter.type + " " + element_name(parameter.name, parameter.dimensions);
}

} // namespace placedpar
