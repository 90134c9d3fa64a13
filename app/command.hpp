#pragma once

#include "app/exit_code.hpp"
#include "text/program_name.hpp"

#include <functional>
#include <string>
#include <vector>

namespace placedpar {

class Options;

/// A function that carries out a command when the command line has been parsed.
using Action = std::function<ExitCode()>;

/// A command of the program, such as `run`. Each command is defined in its own file: see app/README.md.
struct Command {
    const char* name;
    const char* about; ///< the command's line in --help
    int place;         ///< position in --help; multiples of ten leave room for further commands
    /// Declares the options of the command and returns its action. `typed` is the whole command line, which is stored
    /// with the results.
    Action (*declare)(Options& command, const std::string& typed);
    /// Returns the possible values of the command's argument, for completion by a shell; null if the argument is a file
    /// or the command has no argument.
    std::vector<std::string> (*values)() = nullptr;
};

/// Returns the commands that every program has: the commands in the folder `commands`, except further_commands().
std::vector<Command> program_commands();
/// Returns the additional commands of the program placedpar. They need parts of the project that a user's own program
/// need not link.
std::vector<Command> further_commands();
/// Returns the commands of the running program. REQUIRES: carry_out() has begun.
const std::vector<Command>& commands();

/// The name, description and commands of a program. If the name is "", program_name() stays unchanged.
struct Program {
    std::string name, about;
    std::vector<Command> commands;
};

/// Parses a command line without carrying it out, to check it. Reports errors on standard error or throws UserError.
void read_command_line(const std::vector<Command>& commands, int argc, char** argv);

/// Carries out the command line of the program. program_name() returns the program's name from then on. Help lists
/// commands in the order of Command::place. Reports errors on standard error and returns the exit code of main().
/// Ignores SIGPIPE: see print_out(). `begin` is called first, and its exceptions are reported, too.
int carry_out(
    Program program, int argc, char** argv, const std::function<void()>& begin = [] {});

} // namespace placedpar
