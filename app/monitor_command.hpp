#pragma once

#include "app/command.hpp"

namespace CLI {
class App;
}

namespace placedpar::monitor {

/// Declares `placedpar monitor`, which serves until SIGINT or SIGTERM: it prints where it listens, and on standard
/// error what the operator should know.
void declare(CLI::App& app, ChosenCommand& chosen);

} // namespace placedpar::monitor
