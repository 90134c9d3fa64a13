#include "app/command.hpp"

#include <CLI/CLI.hpp>

int main(int argc, char** argv) {
    CLI::App app{"PlacedPar simulates transputer networks and the CSP processes placed on them.", "placedpar"};
    return placedpar::carry_out(app, placedpar::commands(), argc, argv);
}
