// Two processes of a program that uses PlacedPar as a library, and something of every room.

#include "gaprocs/genome.hpp"
#include "hydraulics/circuit/boom_orifices.hpp"
#include "netlist/kinds/catalogue.hpp"
#include "runtime/simulation.hpp"

#include <cstdio>

int main() {
    placedpar::Simulation simulation;
    placedpar::Channel<int> c("c");
    int received = 0;
    simulation.process("sender", [&] { c.out().output(42); });
    simulation.process("receiver", [&] { received = c.in().input(); });
    bool completed = simulation.run().ending == placedpar::Ending::completed;
    bool others = placedpar::Genome::from_string("101").field(0, 3) == 5 && !placedpar::Catalogue().find("none");
    std::printf("received %d\n", received);
    return completed && received == 42 && others ? 0 : 1;
}
