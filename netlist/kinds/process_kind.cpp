#include "netlist/kinds/process_kind.hpp"

#include "netlist/network/names.hpp"

namespace placedpar {

const PortDescription* ProcessKind::port(std::string_view wanted) const { return find_named(ports, wanted); }

const ParameterDescription* ProcessKind::parameter(std::string_view wanted) const {
    return find_named(parameters, wanted);
}

} // namespace placedpar
