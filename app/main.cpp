#include "app/command.hpp"
#include "workbench/manifest.hpp"

#include <CLI/CLI.hpp>

int main(int argc, char** argv) {
    CLI::App app{"PlacedPar simulates transputer networks and the CSP processes placed on them.", "placedpar"};
    app.set_version_flag("--version", "placedpar " + placedpar::version_text());
    return placedpar::carry_out(app, placedpar::commands(), argc, argv);
}
