#pragma once

#include <string>

namespace placedpar {

/// Returns the program's name in help and messages: "placedpar", or the name of another program that uses
/// run_program().
const std::string& program_name();
/// Sets the name. REQUIRES: called by one thread, before any message.
void set_program_name(std::string name);

} // namespace placedpar
