#include "app/command.hpp"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

int main(int argc, char** argv) {
    std::vector<placedpar::Command> commands = placedpar::program_commands();
    std::ranges::move(placedpar::further_commands(), std::back_inserter(commands));
    return placedpar::carry_out({"placedpar",
                                 "PlacedPar simulates transputer networks and the CSP processes placed on them.",
                                 std::move(commands)},
                                argc, argv);
}
