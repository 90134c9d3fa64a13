#include "netlist/kinds/description.hpp"

namespace placedpar::description {

namespace {

/// Converts an optional integer, real or text to an optional Value.
template <class T>
std::optional<Value> as_value(std::optional<T> value) {
    return value ? std::optional<Value>(std::move(*value)) : std::nullopt;
}

template <class Traits>
ParameterDescription number(std::string name, ParameterType type, Traits traits, std::string about) {
    return {.name = std::move(name),
            .type = type,
            .unit = std::move(traits.unit),
            .default_value = as_value(traits.by_default),
            .least = traits.least,
            .most = traits.most,
            .choices = {},
            .about = std::move(about)};
}

} // namespace

ParameterDescription integer(std::string name, IntegerTraits traits, std::string about) {
    return number(std::move(name), ParameterType::integer, std::move(traits), std::move(about));
}

ParameterDescription real(std::string name, RealTraits traits, std::string about) {
    return number(std::move(name), ParameterType::real, std::move(traits), std::move(about));
}

ParameterDescription text(std::string name, TextTraits traits, std::string about) {
    return {.name = std::move(name),
            .type = ParameterType::text,
            .unit = "",
            .default_value = as_value(std::move(traits.by_default)),
            .least = {},
            .most = {},
            .choices = std::move(traits.choices),
            .about = std::move(about),
            .check = std::move(traits.check)};
}

ParameterDescription deciding(std::string noun, ParameterDescription parameter) {
    parameter.noun = std::move(noun);
    return parameter;
}

} // namespace placedpar::description
