#pragma once

#include <string>

namespace placedpar {

/// Returns the program's name in help and messages: "placedpar", or the name that set_program_name() has set.
const std::string& program_name();
/// Sets the name, for a user's program that is built on PlacedPar. REQUIRES: called by one thread, before any message.
void set_program_name(std::string name);
/// Returns the text in quotes, if a shell needs them to read the text as one word of a command.
std::string shell_word(const std::string& text);

} // namespace placedpar
