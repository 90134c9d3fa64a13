#include "netlist/kinds/parameter.hpp"

#include <fmt/format.h>

namespace placedpar {

std::string range_of(const ParameterDescription& parameter) {
    auto unit = parameter.unit.empty() ? "" : " " + parameter.unit;
    if (parameter.least && parameter.most)
        return fmt::format("it goes from {} to {}{}", *parameter.least, *parameter.most, unit);
    if (parameter.least)
        return fmt::format("it is at least {}{}", *parameter.least, unit);
    return fmt::format("it is at most {}{}", parameter.most.value(), unit);
}

bool in_range(const ParameterDescription& parameter, double number) {
    return (!parameter.least || number >= *parameter.least) && (!parameter.most || number <= *parameter.most);
}

} // namespace placedpar
