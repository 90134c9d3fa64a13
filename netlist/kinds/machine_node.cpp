#include "netlist/kinds/machine_node.hpp"

#include "netlist/kinds/device_kind.hpp"
#include "runtime/hardware/router.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace placedpar {

CarrierPair MachineNode::carriers(std::size_t) {
    throw std::logic_error(fmt::format("\"{}\", {}, carries no channels", node().name, node().kind->noun));
}

void MachineNode::carry(AnyChannel&, const RouteHop&) {
    throw std::logic_error(fmt::format("\"{}\", {}, ends no channels", node().name, node().kind->noun));
}

hardware::SharedEngine& MachineNode::engine(int link, bool outputs) {
    hardware::SharedEngine fresh{link_name(network().nodes, {node_, link})};
    return engines_.try_emplace({link, outputs}, std::move(fresh)).first->second;
}

hardware::RouterCosts MachineNode::router_costs() const { return {}; }

hardware::Router& MachineNode::router() {
    if (!router_)
        router_ = &simulation().add<hardware::Router>(executive(), router_costs());
    return *router_;
}

} // namespace placedpar
