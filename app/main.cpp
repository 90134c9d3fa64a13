#include "app/command.hpp"
#include "workbench/manifest.hpp"

#include <CLI/CLI.hpp>

#include <string>

int main(int argc, char** argv) {
    CLI::App app{"PlacedPar simulates transputer networks and the CSP processes placed on them.", "placedpar"};
    app.set_version_flag("--version", std::string("placedpar ") + placedpar::version);
    return placedpar::carry_out(app, placedpar::commands(), argc, argv);
}
