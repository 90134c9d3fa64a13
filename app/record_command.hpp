#pragma once

#include "app/command.hpp"

namespace CLI {
class App;
}

namespace placedpar {

/// Adds `placedpar record SCENARIO` and its options.
void declare_record(CLI::App& app, ChosenCommand& chosen);

} // namespace placedpar
