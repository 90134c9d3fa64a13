#include "gaprocs/processes/kinds.hpp"

#include "gaprocs/processes/messages.hpp"
#include "gaprocs/processes/search_description.hpp"
#include "gaprocs/processes/search_process.hpp"
#include "netlist/kinds/description.hpp"

namespace placedpar {

namespace {

search_description::Parameters ring_parameters() {
    return {description::integer("exchange_every", {.unit = "generations", .by_default = 3, .least = 1, .most = 1e6},
                                 "how often the islands exchange their best individuals (thesis 4.3)")};
}

PortDescription ring_out() {
    return description::optional(description::output<Emigrant>("ring_out", "emigrant", "to the next island"));
}

PortDescription ring_in() {
    return description::optional(description::input<Emigrant>("ring_in", "emigrant", "from the island before"));
}

} // namespace

ProcessKind island_kind(const ProblemRegistry& problems) {
    using namespace search_description;
    return searching({.name = "ga.island",
                      .about =
                          "An island of algorithm B: a genetic algorithm of its own that exchanges its best individual "
                          "around a ring. With slaves it is a master as well (A + B); without a ring it is that only.",
                      .ports = {ring_out(), ring_in(), from_host(), to_slaves(), from_slaves()},
                      .parameters = search_parameters() + farm_parameters() + ring_parameters(),
                      .measurements = search_measurements(),
                      .together = {{"to_slaves", "from_slaves"}, {"ring_out", "ring_in"}}},
                     problems);
}

} // namespace placedpar
