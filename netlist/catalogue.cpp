#include "netlist/catalogue.hpp"

#include <algorithm>
#include <stdexcept>

namespace placedpar {

const PortDescription* ProcessKind::port(std::string_view wanted) const {
    auto found = std::ranges::find(ports, wanted, &PortDescription::name);
    return found == ports.end() ? nullptr : &*found;
}

const ParameterDescription* ProcessKind::parameter(std::string_view wanted) const {
    auto found = std::ranges::find(parameters, wanted, &ParameterDescription::name);
    return found == parameters.end() ? nullptr : &*found;
}

void Catalogue::add(ProcessKind kind) {
    auto name = kind.name;
    if (!kinds_.emplace(name, std::move(kind)).second)
        throw std::logic_error("process kind \"" + name + "\" is in the catalogue already");
}

const ProcessKind* Catalogue::find(std::string_view name) const {
    auto found = kinds_.find(name);
    return found == kinds_.end() ? nullptr : &found->second;
}

} // namespace placedpar
