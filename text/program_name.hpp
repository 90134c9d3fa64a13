#pragma once

#include <string>

namespace placedpar {

/// Returns the program's name in help and messages: "placedpar", or the name of a program that run_program() makes.
const std::string& program_name();
/// REQUIRES: called by one thread, before any message.
void set_program_name(std::string name);

} // namespace placedpar
