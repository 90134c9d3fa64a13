#pragma once

#include "app/command.hpp"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace placedpar {

/// Gives the app its commands, in the order of their places, and does what the command line asks of them. Errors are
/// reported on standard error. Returns the exit code of main().
int carry_out(CLI::App& app, std::vector<Command> commands, int argc, char** argv);

} // namespace placedpar
