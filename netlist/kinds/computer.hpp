#pragma once

#include "netlist/kinds/device_kind.hpp"

#include <string>
#include <vector>

namespace placedpar {

inline constexpr std::int64_t kilobyte = 1024, megabyte = 1024 * 1024;

/// Returns descriptions of the attributes of devices that execute processes: memory, clock, speed of the links, cost of
/// a channel operation and others.
std::vector<AttributeDescription> computer_attributes();
/// Returns the names of the attributes that only INMOS's configurer icconf uses. They have no effect on a simulation.
std::vector<std::string> attributes_of_the_real_tool();

/// Returns a text such as "20 MHz", for drawings. REQUIRES: the value is an integer, in Hz.
std::string megahertz(const Value& frequency);

} // namespace placedpar
