#include "gaprocs/processes/slave_routes.hpp"

#include "gaprocs/processes/slave_tree.hpp"
#include "netlist/kinds/environment.hpp"

#include <algorithm>
#include <numeric>

namespace placedpar {

SlaveRoutes::Hop SlaveRoutes::to(std::size_t slave) const {
    std::size_t channel = 0;
    while (channel < behind_.size() && slave >= behind_[channel])
        slave -= behind_[channel++];
    return {channel, slave};
}

std::vector<std::size_t> SlaveRoutes::in_turn(std::size_t slaves) const {
    std::vector<std::size_t> order(slaves);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [this](std::size_t slave) { return to(slave).address; });
    return order;
}

SlaveRoutes read_routes(const ProcessEnvironment& environment) {
    return SlaveRoutes(count_slaves_behind(environment.network(), environment.index()));
}

} // namespace placedpar
