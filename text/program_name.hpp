#pragma once

#include <string>

namespace placedpar {

/// Returns the program's name in help and messages: "placedpar", or the name of another program that uses
/// run_program().
const std::string& program_name();
/// Sets the name. REQUIRES: called by one thread, before any message.
void set_program_name(std::string name);
/// Quotes the text so that a shell reads it as one word of a command.
std::string shell_word(const std::string& text);

} // namespace placedpar
