#include "gaprocs/processes/kinds.hpp"

#include "gaprocs/policies/acceptance.hpp"
#include "gaprocs/policies/emigration.hpp"
#include "gaprocs/policies/schedule.hpp"
#include "gaprocs/policies/topology.hpp"
#include "gaprocs/processes/archipelago.hpp"
#include "gaprocs/processes/island_checks.hpp"
#include "gaprocs/processes/messages.hpp"
#include "gaprocs/processes/search_description.hpp"
#include "gaprocs/processes/search_process.hpp"
#include "netlist/kinds/description.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace placedpar {

namespace {

using namespace search_description;

Parameters exchange_parameters() {
    return {
        description::deciding(
            "schedule",
            description::integer(
                "exchange_every", {.unit = "generations", .by_default = 3, .least = 1, .most = 1e6},
                "number of generations from one exchange to the next (thesis 4.3), if the schedule does not state it")),
        policy<Schedule>("schedule", "broadcast", "when emigrants leave, and to which neighbours they go"),
        policy<Emigration>("emigration", Emigration().text(), "which individuals leave as copies, and how many"),
        policy<Acceptance>("acceptance", Acceptance().text(), "which individual an immigrant replaces"),
        policy<Topology>("topology", "given",
                         "\"given\": the neighbours are the islands connected to the ports; another name: the topology "
                         "of all islands, numbered in the order of declaration; the connections must agree with it")};
}

PortDescription to_neighbours() {
    using namespace description;
    return optional(formerly(
        "ring_out",
        output<Emigrants>(
            "to_neighbours", "emigrants",
            "an array: one end for each island to which emigrants go, in the order of a sequential schedule")));
}

PortDescription from_neighbours() {
    using namespace description;
    return optional(formerly(
        "ring_in", input<Emigrants>("from_neighbours", "emigrants",
                                    "an array: one end for each island from which immigrants come, in any order")));
}

PortDescription to_analyst() {
    using namespace description;
    return optional(output<EstimateMessage>(
        "to_analyst", "estimate", "the island's best individual, after every generation in which an exchange is due"));
}

ProcessKind with_exchange(ProcessKind searching, const ProblemRegistry& problems) {
    searching.check = [&problems, check_search = std::move(searching.check)](const Network& network,
                                                                             std::size_t process) {
        auto first = std::ranges::find(network.processes, "ga.island", &ProcessInstance::kind);
        if (first - network.processes.begin() != static_cast<std::ptrdiff_t>(process))
            return std::vector<Complaint>(); // the first island checks all islands
        return check_islands(network, problems, [&](std::size_t island) { return check_search(network, island); });
    };
    searching.is_determinate = [](const Network& network,
                                  std::size_t process) { // an asynchronous island depends on the times at which
                                                         // emigrants arrive
        return schedule_of(network.processes[process]).in_step();
    };
    return searching;
}

} // namespace

ProcessKind island_kind(const ProblemRegistry& problems, SearchObserver* observer, Checkpoints* checkpoints) {
    return with_exchange(
        searching({.name = "ga.island",
                   .about = "An island of algorithm B: a genetic algorithm of its own that exchanges individuals with "
                            "its neighbours. With slaves it is a master as well (A + B).",
                   .ports = {to_neighbours(), from_neighbours(), from_host(), to_host(), to_slaves(), from_slaves(),
                             to_analyst()},
                   .parameters = search_parameters() + farm_parameters() + exchange_parameters(),
                   .measurements = search_measurements(),
                   .together = {{"to_slaves", "from_slaves"}}},
                  problems, observer, checkpoints),
        problems);
}

} // namespace placedpar
