#include "netlist/kinds/catalogue.hpp"

#include "netlist/kinds/csp_kinds.hpp"
#include "netlist/kinds/description.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace placedpar;

TEST_CASE("a second kind of the same name is refused") {
    Catalogue catalogue;
    add_csp_kinds(catalogue);
    CHECK_THROWS_WITH_AS(add_csp_kinds(catalogue),
                         "the process kind \"csp.producer\" is in the catalogue already; use another name",
                         std::logic_error);
    CHECK_THROWS_WITH_AS(catalogue.add_device({.name = "edge", .noun = "an edge", .about = ""}),
                         "the device kind \"edge\" is in the catalogue already; use another name", std::logic_error);
    CHECK_THROWS_WITH_AS(catalogue.add_device({.name = "x", .noun = "an x", .about = "", .models = {{.name = "T800"}}}),
                         "the node type \"T800\" is in the catalogue already; use another name", std::logic_error);
    CHECK_THROWS_AS(
        catalogue.add_device(
            {.name = "y", .noun = "a y", .about = "", .attributes = {{.value = description::integer("n", {}, "")}}}),
        std::logic_error);
}

TEST_CASE("the catalogue's device kinds are complete") {
    Catalogue catalogue;
    std::vector<std::string> names;
    for (const auto& [name, kind] : catalogue.devices()) {
        names.push_back(name);
        CAPTURE(names.back());
        CHECK_FALSE(kind->noun.empty());
        CHECK_FALSE(kind->about.empty());
        CHECK_FALSE(kind->models.empty());
        for (const AttributeDescription& attribute : kind->attributes) {
            CHECK_FALSE(attribute.json_name.empty());
            CHECK_FALSE(attribute.value.about.empty());
        }
    }
    for (const char* name : {"bus master", "c004", "edge", "link adapter", "processor", "vme", "workstation"})
        CHECK(std::ranges::count(names, name) == 1);
}

TEST_CASE("models preset the attributes of their kind") {
    Catalogue catalogue;
    const NodeType& module = catalogue.node_types().at("B416");
    CHECK(module.preset.type == "T222");
    CHECK(module.preset.integer("memory") == 64 * 1024);
    CHECK(module.preset.integer("clock") == 20'000'000);
    CHECK(module.links == 4);
    CHECK(catalogue.node_types().at("m212").links == 2);
    CHECK(catalogue.node_types().at("m212").preset.type == "M212");
    CHECK_THROWS_AS(module.preset.integer("colour"), std::logic_error);
}
