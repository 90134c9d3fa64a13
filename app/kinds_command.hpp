#pragma once

#include "app/command.hpp"

namespace CLI {
class App;
}

namespace placedpar {

/// Adds `placedpar kinds`: every kind, a line each; with a name, everything about that kind.
void declare_kinds(CLI::App& app, ChosenCommand& chosen);

} // namespace placedpar
