#include "tests/netlist/small_catalogue.hpp"

#include "netlist/kinds/csp_kinds.hpp"
#include "netlist/kinds/description.hpp"

namespace placedpar {

namespace {

struct Genome {
    int bits = 0;
};
struct Error {
    int value = 0;
};

ProcessKind master() {
    using namespace description;
    return {.name = "ga.master",
            .about = "deals genomes out",
            .ports = {optional(input<int>("in", "number", "")), output<Genome>("out", "genomes", ""),
                      input<Error>("back", "errors", "")},
            .parameters = {integer("population", {.unit = "individuals", .least = 2, .most = 10000}, ""),
                           real("mutation", {.by_default = 0.01, .least = 0, .most = 1}, ""),
                           text("code", {.by_default = "binary", .choices = {"binary", "gray"}}, "")}};
}

ProcessKind slave() {
    using namespace description;
    return {.name = "ga.slave",
            .about = "evaluates genomes",
            .ports = {input<Genome>("in", "genomes", ""), output<Error>("out", "errors", "")},
            .parameters = {integer("cycles", {.unit = "cycles", .by_default = 1000, .least = 0}, "")}};
}

ProcessKind pump() {
    return {.name = "pump", .about = "sends numbers", .ports = {description::output<int>("out", "number", "")}};
}

ProcessKind sink() {
    return {.name = "sink", .about = "takes numbers", .ports = {description::input<int>("in", "number", "")}};
}

Catalogue make_catalogue() {
    Catalogue catalogue;
    for (auto kind : {master(), slave(), pump(), sink(), switch_logic_kind(), switch_setter_kind()})
        catalogue.add(std::move(kind));
    return catalogue;
}

} // namespace

const Catalogue& small_catalogue() {
    static const Catalogue catalogue = make_catalogue();
    return catalogue;
}

std::string netlist_folder() { return std::string(PLACEDPAR_SOURCE_DIR) + "/tests/netlist"; }

} // namespace placedpar
