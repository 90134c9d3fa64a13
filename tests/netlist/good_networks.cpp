#include "tests/netlist/good_networks.hpp"

#include "tests/netlist/small_catalogue.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace placedpar {

namespace {

Network network_of(const ReadResult& result) {
    INFO(render(result.diagnostics));
    REQUIRE(result.network);
    return *result.network;
}

} // namespace

Network good(const std::string& name, const Overrides& overrides) {
    return network_of(read_netlist(netlist_folder() + "/good/" + name, small_catalogue(), overrides));
}

Network good_text(const std::string& text, const Overrides& overrides) {
    return network_of(read_netlist_text(text, small_catalogue(), overrides));
}

const NetworkChannel& channel(const Network& network, const std::string& name) {
    auto found = std::ranges::find(network.channels, name, &NetworkChannel::name);
    CAPTURE(name);
    REQUIRE(found != network.channels.end());
    return *found;
}

} // namespace placedpar
