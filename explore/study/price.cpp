#include "explore/study/price.hpp"

#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"
#include "text/nearest.hpp"
#include "text/user_error.hpp"

#include <algorithm>
#include <vector>

namespace placedpar {

namespace {

constexpr const char* wire_part = "link";

double price_of_part(const Prices& prices, const std::string& part) {
    const auto found = prices.find(part);
    return found == prices.end() ? 0 : found->second;
}

} // namespace

double price_of(const Network& network, const Prices& prices) {
    double price = price_of_part(prices, wire_part) * static_cast<double>(network.count_wires());
    for (const Node& node : network.nodes)
        price += price_of_part(prices, node.type);
    return price;
}

void require_parts(const Prices& prices, const Catalogue& catalogue) {
    std::vector<std::string> parts{wire_part};
    for (const auto& each : catalogue.node_types())
        parts.push_back(each.first);
    for (const auto& each : prices)
        if (std::ranges::find(parts, each.first) == parts.end())
            throw UserError(unknown_name("part with a price", each.first, parts,
                                         "expected \"link\" or a type of node, such as \"T800\""));
}

} // namespace placedpar
