// Loads every netlist of the language reference.

#include "netlist/print/print.hpp"
#include "netlist/read.hpp"
#include "tests/netlist/small_catalogue.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <sstream>

using namespace placedpar;

namespace {

std::vector<std::string> netlists_of_the_guide() {
    std::ifstream in(std::string(PLACEDPAR_SOURCE_DIR) + "/docs/reference/netlist-language.md");
    std::vector<std::string> netlists;
    bool inside = false;
    for (std::string line; std::getline(in, line);) {
        if (line == "```netlist") {
            inside = true;
            netlists.emplace_back();
        } else if (line == "```") {
            inside = false;
        } else if (inside) {
            netlists.back() += line + "\n";
        }
    }
    return netlists;
}

} // namespace

TEST_CASE("the netlists of the language reference load") {
    auto netlists = netlists_of_the_guide();
    CHECK(netlists.size() == 9);
    for (const auto& text : netlists) {
        auto result = read_netlist_text(text, small_catalogue());
        INFO(text);
        INFO(render(result.diagnostics));
        REQUIRE(result.network);
        CHECK(result.diagnostics.empty());
        auto printed = print_cfs(*result.network);
        CHECK(print_cfs(read_netlist_text(printed, small_catalogue()).network.value()) == printed);
    }
}

TEST_CASE("the reference's netlist with a number of slaves loads for each number") {
    auto text = netlists_of_the_guide().at(1);
    for (int slaves = 0; slaves < 5; ++slaves) {
        auto result = read_netlist_text(text, small_catalogue(), {{"slaves", std::to_string(slaves)}});
        REQUIRE(result.network);
        CHECK(result.network->nodes.size() == static_cast<std::size_t>(1 + slaves));
    }
}
