#pragma once

#include "runtime/transputer/code_lines.hpp"
#include "runtime/transputer/core.hpp"

#include <string>

/// Prints the state of a core, that is, the processor of an emulated transputer, as lines of text.
namespace placedpar::transputer {

/// Returns a word in hexadecimal and as a signed number.
std::string print_word(Word);
/// Returns the name of a link's channel, such as "link 2 output" or "event", or the address of another channel.
std::string print_channel(Word);
/// Returns the registers and clocks, and the registers of a floating-point unit if the core has one.
std::string print_registers(const Core&);
/// Returns the queues of ready processes and of timers, the words of links where processes wait, and the process that
/// is interrupted.
std::string print_queues(const Core&, const CodeLines&);
/// Returns the text that the option --analyse prints for a transputer: registers, flags, queues, and the processes that
/// wait.
std::string print_analysis(const Core&, const CodeLines&);

} // namespace placedpar::transputer
