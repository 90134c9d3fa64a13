#include "netlist/print.hpp"
#include "netlist/read.hpp"
#include "small_catalogue.hpp"

#include <doctest/doctest.h>

using namespace placedpar;

TEST_CASE("four clusters of a master and three slaves") {
    auto result = read_netlist(netlist_folder() + "/good/clusters.cfs", small_catalogue());
    INFO(render(result.diagnostics));
    REQUIRE(result.network);
    const auto& network = *result.network;
    MESSAGE(print_cfs(network));
    auto again = read_netlist_text(print_cfs(network), small_catalogue());
    INFO(render(again.diagnostics));
    REQUIRE(again.network);
    CHECK(print_cfs(*again.network) == print_cfs(network));
}
