#pragma once

#include "app/command.hpp"

#include <string>

namespace CLI {
class App;
}

namespace placedpar {

/// The command line as it was typed, whatever the program's file is called.
std::string typed(int argc, char** argv);

/// Does what the command line asks of the app, whose commands put themselves into `chosen`. What is wrong is said on
/// the standard error. The exit code of main().
int carry_out(CLI::App& app, const ChosenCommand& chosen, int argc, char** argv);

} // namespace placedpar
