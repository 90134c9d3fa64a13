#pragma once

#include "app/command.hpp"

#include <string>

namespace CLI {
class App;
}

namespace placedpar {

/// Adds `placedpar identify RECORD` and its options. `command_line` is what was typed, for the manifest.
void declare_identify(CLI::App& app, ChosenCommand& chosen, const std::string& command_line);

} // namespace placedpar
