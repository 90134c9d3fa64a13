#pragma once

#include "app/exit_code.hpp"
#include "text/program_name.hpp"

#include <functional>
#include <string>
#include <vector>

namespace placedpar {

class Options;

/// What a command does, once the command line has been parsed.
using Action = std::function<ExitCode()>;

/// What the file of a command says about it: see app/README.md.
struct Command {
    const char* name;
    const char* about; ///< its line in --help
    int place;         ///< in --help; multiples of ten leave room between them
    /// Gives the subcommand its options, and returns what to do with them. `typed` is the whole command line, for
    /// manifests.
    Action (*declare)(Options& command, const std::string& typed);
    /// The names that its argument can have, for a shell to complete; null where that is a file, or nothing.
    std::vector<std::string> (*values)() = nullptr;
};

/// The commands of every program, one of each file in the folder commands but for further_commands().
std::vector<Command> program_commands();
/// The commands that placedpar has besides: they need rooms that a program of one's own does not link.
std::vector<Command> further_commands();
/// The commands of this program, once carry_out() has begun.
const std::vector<Command>& commands();

/// What a program is called, "" for program_name(), and what it says of itself.
struct Program {
    std::string name, about;
    std::vector<Command> commands;
};

/// Reads a command line without doing what it asks for. What is wrong is said on standard error, or a UserError is
/// thrown.
void read_command_line(const std::vector<Command>& commands, int argc, char** argv);

/// Does what the command line asks of the program, whose name is program_name() from then on; its commands are in the
/// order of their places. Errors are reported on standard error. Returns the exit code of main(). Ignores SIGPIPE: see
/// print_out(). `begin` is called first; what it throws is reported, too.
int carry_out(
    Program program, int argc, char** argv, const std::function<void()>& begin = [] {});

} // namespace placedpar
