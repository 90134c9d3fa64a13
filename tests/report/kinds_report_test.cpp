#include "netlist/kinds/description.hpp"
#include "report/kinds_report.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

using namespace placedpar;

namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

} // namespace

TEST_CASE("each device is listed once, with the names that declare it") {
    std::string all = print_kinds(Catalogue());
    CHECK(contains(all, "  C004             A crossbar switch"));
    CHECK(contains(all, "  workstation      A host computer"));
    CHECK(contains(all, "  processor        A transputer, bare or on a module; B403_T414 is a B403 with a T414.\n      "
                        "             T805 "));
    CHECK(contains(all, " T800 B011 B401 B403 B404 "));
    CHECK_FALSE(contains(all, "t800"));
    CHECK(contains(all, "\n                   C011 C012\n"));
    CHECK(contains(all, "\n                   busmaster BBKV2\n"));
}

TEST_CASE("a device is described by its attributes, with the model's values as defaults") {
    Catalogue catalogue;
    std::string module = print_kind(catalogue, "B404");
    CHECK(module.starts_with("B404 (T800)\nA transputer, bare or on a module; B403_T414 is a B403 with a T414.\n"
                             "links: 4; each byte is acknowledged while it arrives\nprocesses: can be placed on it\n"));
    CHECK(contains(module, "memory                       int     default 2097152        1 .. 4294967296"));
    CHECK(contains(module,
                   "clock                        int     default 20000000       1 .. 1000000000              Hz"));
    CHECK(contains(module, "noprofile, pagesize\n"));
    CHECK(contains(print_kind(catalogue, "T414"), "each byte is acknowledged when it has arrived"));
    CHECK(contains(print_kind(catalogue, "t800"), "memory                       int     default 4096 "));
    CHECK(print_kind(catalogue, "C004") ==
          "C004\nA crossbar switch: its crosspoints connect its links to each other. If "
          "its link `config` leads to a processor, a program sets the crosspoints during the run.\n"
          "links: 32\nprocesses: a csp.switch_logic, which the link config sets during the "
          "run\n");
    CHECK(contains(print_kind(catalogue, "VME"), "PRI | RRS | SGL"));
    std::string any = print_kind(catalogue, "processor");
    CHECK(contains(any, "type                         string  must be given: one of\n"));
    CHECK_FALSE(contains(any, "processor T805"));
    CHECK_FALSE(contains(any, "links: ")); // the type states the number
}

TEST_CASE("a program's own device is described, and an unknown name is refused") {
    Catalogue catalogue;
    catalogue.add_device(
        {.name = "repeater",
         .noun = "a repeater",
         .about = "Refreshes a signal.",
         .models = {{.name = "R2", .links = 2, .attributes = {{"gain", 2.5}}}},
         .links = LinkRole::crosses,
         .attributes = {
             {.value = description::real("gain", {.unit = "V/V", .by_default = 1.0}, "of it"), .json_name = "gain"}}});
    CHECK(contains(print_kinds(catalogue), "  R2               Refreshes a signal.\n"));
    CHECK(contains(print_kind(catalogue, "R2"), "default 2.5"));
    CHECK_THROWS_WITH_AS(print_kind(catalogue, "R3"),
                         "unknown process kind, device, problem or policy \"R3\"; did you mean \"R2\"?", UserError);
}
