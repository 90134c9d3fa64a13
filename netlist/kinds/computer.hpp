#pragma once

#include "netlist/kinds/device_kind.hpp"

#include <string>
#include <vector>

namespace placedpar {

inline constexpr std::int64_t kilobyte = 1024, megabyte = 1024 * 1024;

/// Returns the attributes of devices on which processes are placed: memory, clock, speed of the links, cost of a
/// channel operation.
std::vector<AttributeDescription> computer_attributes();
/// Returns the attributes that only icconf, INMOS's configurer, uses. They have no effect on a simulation.
std::vector<std::string> attributes_of_the_real_tool();

/// Returns a text such as "20 MHz", for drawings. REQUIRES: the value is an integer, in Hz.
std::string megahertz(const Value& frequency);

} // namespace placedpar
