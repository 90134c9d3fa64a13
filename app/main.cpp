#include "app/command_line.hpp"
#include "app/common_options.hpp"
#include "app/identify_command.hpp"
#include "app/kinds_command.hpp"
#include "app/monitor_command.hpp"
#include "app/netlist_commands.hpp"
#include "app/record_command.hpp"
#include "app/replay_command.hpp"
#include "hydraulics/data/parameters.hpp"
#include "text/standard_output.hpp"
#include "workbench/manifest.hpp"

#include <CLI/CLI.hpp>

#include <string>

using namespace placedpar;
using namespace placedpar::hydraulics;

namespace {

ExitCode print_parameters() {
    print_out(excavator_text());
    return ExitCode::success;
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app{"PlacedPar simulates transputer networks and the CSP processes placed on them."};
    app.set_version_flag("--version", std::string("placedpar ") + version);
    const std::string command_line = typed(argc, argv);
    ChosenCommand chosen;
    declare_netlist_commands(app, chosen, command_line);
    declare_kinds(app, chosen);
    declare_replay(app, chosen, command_line);
    declare_identify(app, chosen, command_line);
    declare_record(app, chosen);
    app.add_subcommand("parameters", "Prints the constants of the excavator, as a file for --machine")->callback([&] {
        chosen = print_parameters;
    });
    monitor::declare(app, chosen);
    return carry_out(app, chosen, argc, argv);
}
