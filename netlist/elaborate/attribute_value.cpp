#include "netlist/elaborate/attribute_value.hpp"

#include "netlist/language/syntax.hpp"
#include "text/nearest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace placedpar {

Value AttributeValue::as(const AttributeDescription& attribute) const {
    if (attribute.value.type == ParameterType::text)
        return word(attribute.value);
    if (attribute.value.type == ParameterType::real)
        return real(attribute.value);
    auto number = attribute.decimal_suffixes ? integer().decimal : integer().value;
    check_range(attribute.value, static_cast<double>(number), fmt::format("{}", number));
    return number;
}

Value AttributeValue::any() const {
    if (const auto* integer = setting_.value.integer())
        return integer->value;
    if (const auto* real = setting_.value.real())
        return *real;
    return text();
}

std::string AttributeValue::text() const {
    if (setting_.value.text() == nullptr)
        wrong_type("a string");
    return *setting_.value.text();
}

std::string AttributeValue::word(const ParameterDescription& description) const {
    std::string word = text();
    const auto& choices = description.choices;
    if (!choices.empty() && std::ranges::find(choices, word) == choices.end())
        illegal(shown(setting_.value), fmt::format("expected one of {}", fmt::join(choices, ", ")));
    return word;
}

const Integer& AttributeValue::integer() const {
    if (setting_.value.integer() == nullptr)
        wrong_type("an integer");
    return *setting_.value.integer();
}

double AttributeValue::real(const ParameterDescription& description) const {
    const auto& value = setting_.value;
    if (!value.is_number())
        wrong_type("a number");
    auto number = value.real() != nullptr ? *value.real() : static_cast<double>(value.integer()->value);
    check_range(description, number, shown(value));
    return number;
}

void AttributeValue::check_range(const ParameterDescription& description, double number,
                                 const std::string& shown_number) const {
    if (!in_range(description, number))
        illegal(shown_number, "expected " + range_of(description));
}

void AttributeValue::illegal(const std::string& value, const std::string& hint) const {
    refuse(fmt::format("illegal value of the attribute \"{}\": {}", setting_.name, value), hint);
}

void AttributeValue::wrong_type(const std::string& wanted) const {
    refuse(fmt::format("wrong type for the attribute \"{}\": {} is {}", setting_.name, shown(setting_.value),
                       type_name(setting_.value)),
           "expected " + wanted);
}

void AttributeValue::refuse_name(const std::string& whose, const std::vector<std::string>& known) const {
    refuse(fmt::format("{} has no attribute \"{}\"", whose, setting_.name), did_you_mean(setting_.name, known));
}

void AttributeValue::refuse(std::string message, std::string hint) const {
    reporter_.error(setting_.at, std::move(message), std::move(hint));
    throw StatementRefused{};
}

bool names_attribute(const std::vector<std::string>& names, const std::string& attribute) {
    return std::ranges::find(names, attribute.substr(0, attribute.find('.'))) != names.end();
}

} // namespace placedpar
