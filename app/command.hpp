#pragma once

#include "app/exit_code.hpp"
#include "text/program_name.hpp"

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace placedpar {

/// What a command does, once the command line has been parsed.
using Action = std::function<ExitCode()>;

/// What the file of a command says about it: see app/README.md.
struct Command {
    const char* name;
    const char* about; ///< its line in --help
    int place;         ///< in --help; multiples of ten leave room between them
    /// Gives the subcommand its options, and returns what to do with them. `typed` is the whole command line, for
    /// manifests.
    Action (*declare)(CLI::App& subcommand, const std::string& typed);
    /// The names that its argument can have, for a shell to complete; null where that is a file, or nothing.
    std::vector<std::string> (*values)() = nullptr;
};

/// The commands of every program, one of each file in the folder commands but for further_commands().
std::vector<Command> program_commands();
/// The commands that placedpar has besides: they need rooms that a program of one's own does not link.
std::vector<Command> further_commands();
/// The commands of this program, once carry_out() has begun.
const std::vector<Command>& commands();

/// The names of the app's commands.
std::vector<std::string> names_of_commands(const CLI::App&);
/// Null where there is none.
const CLI::App* command_called(const CLI::App&, const std::string& name);
/// Of the app or a command, as they are typed: "--seed", "-I".
std::vector<std::string> names_of_options(const CLI::App&);

/// Gives the app its commands, and reads a command line without doing what it asks for. Returns the action; null where
/// it asks for help alone, or is wrong, which is said on standard error then. Throws UserError where it is wrong, too.
Action read_command_line(CLI::App& app, const std::vector<Command>& commands, int argc, char** argv);

/// Gives the app its commands, in the order of their places, and does what the command line asks of them. The app's
/// name is program_name() from then on. Errors are reported on standard error. Returns the exit code of main(). Ignores
/// SIGPIPE: see print_out(). `begin` is called first; what it throws is reported, too.
int carry_out(
    CLI::App& app, std::vector<Command> commands, int argc, char** argv, const std::function<void()>& begin = [] {});

} // namespace placedpar
