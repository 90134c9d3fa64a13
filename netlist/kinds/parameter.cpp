#include "netlist/kinds/parameter.hpp"

#include "text/counted.hpp"

#include <fmt/format.h>

namespace placedpar {

std::string range_of(const ParameterDescription& parameter) {
    if (parameter.least && parameter.most)
        return fmt::format("from {} to {}", *parameter.least, with_unit(*parameter.most, parameter.unit));
    if (parameter.least)
        return fmt::format("at least {}", with_unit(*parameter.least, parameter.unit));
    return fmt::format("at most {}", with_unit(parameter.most.value(), parameter.unit));
}

bool in_range(const ParameterDescription& parameter, double number) {
    return (!parameter.least || number >= *parameter.least) && (!parameter.most || number <= *parameter.most);
}

} // namespace placedpar
