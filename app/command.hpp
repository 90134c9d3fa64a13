#pragma once

#include "app/exit_code.hpp"
#include "text/program_name.hpp"

#include <functional>
#include <string>
#include <vector>

namespace placedpar {

class Options;

/// Carries out a command once the command line has been parsed.
using Action = std::function<ExitCode()>;

/// Describes a command. Each command is defined in its own file: see app/README.md.
struct Command {
    const char* name;
    const char* about; ///< the command's line in --help
    int place;         ///< position in --help; multiples of ten leave room for further commands
    /// Declares the options of the subcommand and returns its action. `typed` is the whole command line, for manifests.
    Action (*declare)(Options& command, const std::string& typed);
    /// Returns the possible values of the command's argument, for completion by a shell; null if the argument is a file
    /// or the command has no argument.
    std::vector<std::string> (*values)() = nullptr;
};

/// Returns the commands that every program has: the commands in the folder `commands`, except further_commands().
std::vector<Command> program_commands();
/// Returns the additional commands of placedpar, which need parts of PlacedPar that other programs do not link.
std::vector<Command> further_commands();
/// Returns the commands of this program. REQUIRES: carry_out() has begun.
const std::vector<Command>& commands();

/// The name, description and commands of a program. The name "" leaves program_name() unchanged.
struct Program {
    std::string name, about;
    std::vector<Command> commands;
};

/// Parses a command line without carrying it out. Reports errors on standard error or throws UserError.
void read_command_line(const std::vector<Command>& commands, int argc, char** argv);

/// Carries out the command line of the program. program_name() returns the program's name from then on. Help lists
/// commands by `place`. Reports errors on standard error and returns the exit code of main(). Ignores SIGPIPE: see
/// print_out(). `begin` is called first, and its exceptions are reported, too.
int carry_out(
    Program program, int argc, char** argv, const std::function<void()>& begin = [] {});

} // namespace placedpar
