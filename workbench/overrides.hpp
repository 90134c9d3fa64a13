#pragma once

#include "netlist/read.hpp"

#include <span>
#include <string>

namespace placedpar {

/// What --set NAME=VALUE asked for. Throws std::runtime_error when one is not of that form or a name is set
/// twice.
Overrides overrides_of(std::span<const std::string> settings);

} // namespace placedpar
