// Tests types of nodes and processes: predefined, defined, and spelled as in real files.

#include "tests/netlist/good_networks.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace placedpar;

namespace {

const ProcessInstance& typed_process(const Network& network, const std::string& name) {
    auto found = std::ranges::find(network.processes, name, &ProcessInstance::name);
    CAPTURE(name);
    REQUIRE(found != network.processes.end());
    return *found;
}

Node declared(const std::string& declaration) { return good_text(declaration + " a;").nodes.at(0); }

} // namespace

TEST_CASE("a processor's type may be in either case, or a board") {
    CHECK(declared("PROCESSOR (type = \"T805\")").type == "T805");
    CHECK(declared("processor (type = \"t805\")").type == "T805");
    CHECK(declared("processor (type = \"B404\")").type == "T800");
    CHECK(declared("processor (type = \"b404\")").integer("memory") == 2 * 1024 * 1024);
    CHECK(declared("processor (memory = 3M, type = \"B404\")").integer("memory") == 3 * 1024 * 1024);
    CHECK(declared("T800 (type = \"t800\")").type == "T800");
    CHECK(declared("define processor (memory = 3M, clock = 25M) fast; fast (type = \"T425\")").integer("clock") ==
          25'000'000);
    CHECK(declared("node (element = \"processor\", type = \"M212\")").type == "M212");
}

TEST_CASE("boards and modules have the processor and memory that they were sold with") {
    struct Board {
        const char *name, *type;
        std::int64_t kilobytes;
    };
    for (const Board& board :
         {Board{"B003", "T414", 256}, Board{"B004", "T414", 2048}, Board{"B401", "T800", 32}, Board{"B402", "T212", 8},
          Board{"B403", "T800", 1024}, Board{"B404", "T800", 2048}, Board{"B405", "T800", 8192},
          Board{"B411", "T800", 1024}, Board{"B416", "T222", 64}, Board{"B417", "T800", 4096},
          Board{"B426", "T800", 4096}, Board{"B403_T414", "T414", 1024}, Board{"B411_T425", "T425", 1024},
          Board{"B404_T805", "T805", 2048}, Board{"B416_T225", "T225", 64}}) {
        CAPTURE(board.name);
        auto node = declared(board.name);
        CHECK(node.type == board.type);
        CHECK(node.integer("memory") == board.kilobytes * 1024);
        CHECK(node.integer("clock") == 20'000'000);
    }
}

TEST_CASE("processes are declared by process types") {
    auto network = good("types.cfs");
    auto kept = [&](const std::string& name, const std::string& attribute) {
        return typed_process(network, name).other.at(attribute);
    };
    CHECK(typed_process(network, "source").high_priority);
    CHECK(typed_process(network, "sink").high_priority); // its own attribute overrides the attribute of its type
    CHECK_FALSE(typed_process(network, "last").high_priority);
    CHECK_FALSE(typed_process(network, "first").high_priority);
    CHECK(typed_process(network, "third").high_priority);
    CHECK(kept("first", "stacksize") == Value(std::int64_t{2048})); // from `process (...);`
    CHECK(kept("third", "heapsize") == Value(std::int64_t{16384}));
    CHECK(typed_process(network, "first").parameters.at("n") == Value(std::int64_t{8}));
    CHECK(typed_process(network, "second[1]").parameters.at("n") == Value(std::int64_t{16}));
    CHECK(typed_process(network, "third").ports.size() == 2);
    CHECK(typed_process(network, "source").kind == "any.lku");
    auto node = [&](const std::string& name) { return *std::ranges::find(network.nodes, name, &Node::name); };
    CHECK(node("root").type == "T805");
    CHECK(node("old").type == "T414");
    CHECK(node("old").integer("memory") == 4 * 1024 * 1024);
}

TEST_CASE("changed attributes of a process type apply to later declarations") {
    auto network = good_text("T800 t; define process (stacksize = 1k) small; small a; small (stacksize = 4k); small b;"
                             "process c; place a on t; place b on t; place c on t;");
    CHECK(typed_process(network, "a").other.at("stacksize") == Value(std::int64_t{1024}));
    CHECK(typed_process(network, "b").other.at("stacksize") == Value(std::int64_t{4096}));
    CHECK(typed_process(network, "c").other.empty());
}

TEST_CASE("type names of the toolset that are not in use can be declared") {
    auto network = good_text("T800 node, PROCESS, B404; connect node.link[0] to PROCESS.link[0];"
                             "connect PROCESS.link[1] to B404.link[0];");
    CHECK(network.nodes[0].name == "node");
    CHECK(network.nodes[1].name == "PROCESS");
    CHECK(network.nodes[2].name == "B404");
}

TEST_CASE("arrays of char rows are arrays of strings") {
    auto network = good("tables.cfs");
    const auto& parameters = typed_process(network, "p[2]").parameters;
    CHECK(parameters.at("all[3]") == Value(std::string("west")));
    CHECK(parameters.at("name") == Value(std::string("south")));
    CHECK(parameters.at("initial") == Value(std::int64_t{'s'}));
    CHECK(parameters.at("raw[1]") == Value(std::int64_t{'b'}));
    CHECK(parameters.at("table[0][1]") == Value(std::int64_t{-2}));
    CHECK(parameters.at("mask") == Value(std::int64_t{(0xF0 & ~(1 << 4)) | (3 ^ 1)}));
}
