#pragma once

#include "app/exit_code.hpp"

#include <functional>

namespace placedpar {

/// What the command line chose to do; empty until it has been parsed.
using ChosenCommand = std::function<ExitCode()>;

} // namespace placedpar
