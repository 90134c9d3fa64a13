// placedpar with nothing but what is done with a netlist. Other compilers build it, to be compared.

#include "app/command_line.hpp"
#include "app/netlist_commands.hpp"

#include <CLI/CLI.hpp>

int main(int argc, char** argv) {
    CLI::App app{"Runs, checks and shows netlists."};
    const std::string command_line = placedpar::typed(argc, argv);
    placedpar::ChosenCommand chosen;
    placedpar::declare_netlist_commands(app, chosen, command_line);
    return placedpar::carry_out(app, chosen, argc, argv);
}
