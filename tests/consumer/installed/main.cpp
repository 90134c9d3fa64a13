// Two processes of a program that uses PlacedPar as a library, and something of every room.

#include "placedpar/experiments/kit/experiment.hpp"
#include "placedpar/gaprocs/representation/genome.hpp"
#include "placedpar/hydraulics/circuit/boom_orifices.hpp"
#include "placedpar/identification/identification.hpp"
#include "placedpar/monitor/service/service.hpp"
#include "placedpar/runtime/channel.hpp"
#include "placedpar/runtime/hardware/link.hpp"
#include "placedpar/runtime/simulation.hpp"
#include "placedpar/workbench/problems.hpp"
#include "runtime/channel.hpp"

#include <cstdio>

namespace {

// With both namespaces opened, Link is the excavator's; the transputers' is hardware::Link.
std::size_t number_of_the_boom() {
    using namespace placedpar;
    using namespace placedpar::hydraulics;
    return index_of(Link::boom);
}

bool every_room_is_there() {
    placedpar::ProblemRegistry problems = placedpar::known_problems(1);
    return placedpar::Genome::from_string("101").field(0, 3) == 5 &&
           placedpar::known_kinds(problems).find("ga.master") &&
           placedpar::identification::service_way().searches > 1 && !placedpar::experiments().empty();
}

} // namespace

int main() {
    placedpar::Simulation simulation;
    placedpar::Channel<int> c("c");
    c.put_on(simulation.add<placedpar::hardware::Link>().from_a_to_b());
    int received = 0;
    simulation.process("sender", [&] { c.out().output(Channel{42}.number); });
    simulation.process("receiver", [&] { received = c.in().input(); });
    bool completed = simulation.run().ending == placedpar::Ending::completed;
    std::printf("received %d\n", received);
    return completed && received == 42 && number_of_the_boom() == 1 && every_room_is_there() ? 0 : 1;
}
