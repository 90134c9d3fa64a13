#include "app/command.hpp"

#include "text/output_file.hpp"
#include "text/user_error.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>

namespace placedpar {

namespace {

bool is_command(const CLI::App& app, std::string_view name) {
    return std::ranges::any_of(app.get_subcommands({}), [&](const CLI::App* each) { return each->get_name() == name; });
}

std::string& name_of_program() {
    static std::string name = "placedpar";
    return name;
}

/// The command line as it was typed, wherever the program's file is.
std::string typed(int argc, char** argv) {
    std::string text = program_name();
    for (int i = 1; i < argc; ++i)
        text += " " + std::string(argv[i]);
    return text;
}

void declare(CLI::App& app, const Command& command, const std::string& command_line, Action& chosen) {
    CLI::App* subcommand = app.add_subcommand(command.name, command.about);
    Action action = command.declare(*subcommand, command_line);
    subcommand->callback([&chosen, action] { chosen = action; });
}

void require_command(const CLI::App& app, int argc, char** argv) {
    if (argc > 1 && argv[1][0] != '-' && !is_command(app, argv[1]))
        throw UserError(
            fmt::format("there is no command \"{}\"; say {} --help for those there are", argv[1], program_name()));
}

/// Parses the command line. What it chose is then in `chosen`, or it was wrong, or asked for help.
ExitCode parse(CLI::App& app, int argc, char** argv) {
    try {
        app.parse(argc, argv);
        return ExitCode::success;
    } catch (const CLI::ParseError& error) {
        std::ostringstream help, wrong;
        bool asked_for_help = app.exit(error, help, wrong) == 0;
        print_out(help.str());
        fmt::print(stderr, "{}", wrong.str());
        return asked_for_help ? ExitCode::success : ExitCode::bad_input;
    }
}

/// What the command line asks for. Throws what the command throws.
ExitCode execute(CLI::App& app, const Action& chosen, int argc, char** argv) {
    require_command(app, argc, argv);
    ExitCode parsed = parse(app, argc, argv);
    return chosen ? chosen() : parsed;
}

ExitCode report_defect(const char* what) {
    fmt::print(stderr,
               "{}: defect of PlacedPar: {}\n"
               "please report it, with the command and the files that it was given\n",
               program_name(), what);
    return ExitCode::defect;
}

/// Reports the exception that is being handled. Nobody is to blame for what the system refuses, such as memory or a
/// file; what is neither that nor a UserError should not have happened.
ExitCode report_error() {
    try {
        throw;
    } catch (const RefusedInput& refused) {
        fmt::print(stderr, "{}", refused.what());
    } catch (const UserError& error) {
        fmt::print(stderr, "{}: {}\n", program_name(), error.what());
    } catch (const std::system_error& error) {
        fmt::print(stderr, "{}: {}\n", program_name(), error.what());
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "{}: there is not enough memory\n", program_name());
    } catch (const std::exception& error) {
        return report_defect(error.what());
    }
    return ExitCode::bad_input;
}

} // namespace

const std::string& program_name() { return name_of_program(); }

int carry_out(CLI::App& app, std::vector<Command> commands, int argc, char** argv) {
    Action chosen;
    std::signal(SIGPIPE, SIG_IGN);
    if (!app.get_name().empty())
        name_of_program() = app.get_name();
    std::ranges::sort(commands, {}, &Command::place);
    for (const Command& command : commands)
        declare(app, command, typed(argc, argv), chosen);
    app.name(program_name());
    app.require_subcommand(1);
    app.footer( // last: a subcommand takes over the footer that its parent has when it is added
        "The name of a file can be -: standard input or output.\n"
        "exit codes: 0 success, 1 wrong use or bad input, 2 deadlock, 3 a comparison missed its tolerance,\n"
        "            70 a defect of PlacedPar, 130 interrupted");
    try {
        return static_cast<int>(execute(app, chosen, argc, argv));
    } catch (...) {
        return static_cast<int>(report_error());
    }
}

} // namespace placedpar
