#include "picture/svg.hpp"

#include "tests/picture/networks.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace placedpar;
using picture::network_of;

namespace {

std::size_t count_of(const std::string& svg, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = svg.find(part); at != svg.npos; at = svg.find(part, at + part.size()))
        ++found;
    return found;
}

} // namespace

TEST_CASE("the drawing names every node and every process, and has a path for each wire") {
    const std::string svg = print_svg(network_of(picture::chain(3) + picture::stream("t[0]", "t[2]")));
    for (const char* text : {"t[0]", "t[1]", "t[2]", "p", "c", "csp.producer"})
        CHECK(count_of(svg, ">" + std::string(text) + "<") == 1);
    CHECK(count_of(svg, "data-wire=") + count_of(svg, "class=\"wire") >= 2);
}

TEST_CASE("a wire without channels is drawn as idle, and the legend says what that means") {
    const std::string idle = print_svg(network_of(picture::chain(2)));
    CHECK(count_of(idle, "idle\"") >= 1);
    const std::string busy = print_svg(network_of(picture::chain(2) + picture::stream("t[0]", "t[1]")));
    CHECK(count_of(busy, "class=\"wire idle\"") == 0);
}

TEST_CASE("the legend calls what leads to a shared memory a line, and what is numbered there a slot") {
    const std::string memory = "core c[2]; shared_memory m; rep i = 0 for 2 connect c[i].bus[0] to m.slot[i + 1];";
    const std::string cores = print_svg(network_of(memory));
    CHECK(count_of(cores, ">line without a channel<") == 1);
    CHECK(count_of(cores, ">number of a slot<") == 1);
    CHECK(count_of(cores, ">wire") + count_of(cores, "number of a link") == 0);
    const std::string both = print_svg(network_of(memory + picture::chain(2)));
    CHECK(count_of(both, ">number of a link or slot<") == 1);
    CHECK(count_of(print_svg(network_of(picture::chain(2))), ">number of a link<") == 1);
}

TEST_CASE("names with XML characters are escaped") {
    const std::string svg = print_svg(network_of("T800 t; process p; use \"a<b>&c\" for p; place p on t;"));
    CHECK(svg.find("a&lt;b&gt;&amp;c") != std::string::npos);
    CHECK(svg.find("a<b>") == std::string::npos);
}

TEST_CASE("faults are drawn, and their style only if there are faults") {
    const std::string sound = print_svg(network_of(picture::chain(2))),
                      struck = print_svg(network_of(picture::chain(2) + "fault t[0].link[1] silent (from = 1ms);"));
    CHECK(count_of(sound, "struck") == 0);
    CHECK(count_of(struck, "struck") >= 1);
    CHECK(count_of(struck, ">silent from 1 ms<") == 1);
}

TEST_CASE("the software is drawn with a channel's port at its sender") {
    const std::string svg = print_software_svg(network_of(picture::chain(2) + picture::stream("t[0]", "t[1]")));
    CHECK(count_of(svg, ">p<") == 1);
    CHECK(count_of(svg, ">out<") >= 1);
    CHECK(count_of(svg, "on t[1]") >= 1);
}
