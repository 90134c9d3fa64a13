// The smallest program that uses PlacedPar.

#include "placedpar/runtime/simulation.hpp"

int main() {
    placedpar::Simulation simulation;
    bool ran = false;
    simulation.process("only", [&] { ran = true; });
    simulation.run();
    return ran ? 0 : 1;
}
