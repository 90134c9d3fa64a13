#pragma once

#include "app/command.hpp"

#include <string>

namespace CLI {
class App;
}

namespace placedpar {

/// Adds `placedpar replay EXPERIMENT` and its options. `command_line` is what was typed, for the cells' file.
void declare_replay(CLI::App& app, ChosenCommand& chosen, const std::string& command_line);

} // namespace placedpar
