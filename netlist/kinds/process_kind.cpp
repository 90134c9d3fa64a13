#include "netlist/kinds/process_kind.hpp"

#include "netlist/network/names.hpp"
#include "text/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar {

const PortDescription* ProcessKind::port(std::string_view wanted) const { return find_named(ports, wanted); }

const ParameterDescription* ProcessKind::parameter(std::string_view wanted) const {
    return find_named(parameters, wanted);
}

std::string ProcessKind::hint_at_port(std::string_view wanted) const {
    auto renamed = std::ranges::find(ports, wanted, &PortDescription::formerly);
    return renamed == ports.end() ? did_you_mean(wanted, names_in(ports))
                                  : fmt::format("its name is now \"{}\"", renamed->name);
}

} // namespace placedpar
