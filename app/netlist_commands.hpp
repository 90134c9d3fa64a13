#pragma once

#include "app/command.hpp"

#include <string>

namespace CLI {
class App;
}

namespace placedpar {

/// `placedpar run`, `check` and `show`: what is done with one netlist. `command_line` is what was typed, for the
/// report.
void declare_netlist_commands(CLI::App& app, ChosenCommand& chosen, const std::string& command_line);

} // namespace placedpar
