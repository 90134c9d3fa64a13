#pragma once

#include "netlist/network/network.hpp"
#include "runtime/time.hpp"

#include <string>

namespace placedpar {

/// Returns true for the chips with words of 16 bits: T212, T222, T225, M212.
inline bool has_short_words(const std::string& chip) { return chip[1] == '2'; }

/// Returns the access time of the memory that holds a processor's messages. Assumption: messages are in external memory
/// if the processor has external memory.
Cycles access_time(const Node& node);

} // namespace placedpar
