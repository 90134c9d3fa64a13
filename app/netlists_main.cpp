// placedpar with nothing but what is done with a netlist. Other compilers build it, to be compared.

#include "app/command.hpp"

#include <CLI/CLI.hpp>

namespace placedpar {

extern const Command run_command, check_command, show_command;

} // namespace placedpar

int main(int argc, char** argv) {
    CLI::App app{"Runs, checks and shows netlists."};
    return placedpar::carry_out(app, {placedpar::run_command, placedpar::check_command, placedpar::show_command}, argc,
                                argv);
}
