#include "netlist/kinds/process_kind.hpp"

#include <algorithm>

namespace placedpar {

const PortDescription* ProcessKind::port(std::string_view wanted) const {
    auto found = std::ranges::find(ports, wanted, &PortDescription::name);
    return found == ports.end() ? nullptr : &*found;
}

const ParameterDescription* ProcessKind::parameter(std::string_view wanted) const {
    auto found = std::ranges::find(parameters, wanted, &ParameterDescription::name);
    return found == parameters.end() ? nullptr : &*found;
}

} // namespace placedpar
