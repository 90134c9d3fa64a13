#include "app/command.hpp"

#include "text/nearest.hpp"
#include "text/output_file.hpp"
#include "text/paint.hpp"
#include "text/user_error.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>

namespace placedpar {

namespace {

std::vector<std::string> commands_of(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* each : app.get_subcommands({}))
        names.push_back(each->get_name());
    return names;
}

/// As they are typed: "--seed", "-I".
std::vector<std::string> options_of(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_lnames())
            names.push_back("--" + name);
        for (const std::string& name : option->get_snames())
            names.push_back("-" + name);
    }
    return names;
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

/// CLI11 would miss a command before it looked at what is there instead.
void require_command(const CLI::App& app, const std::string& first) {
    bool option = first.starts_with('-');
    std::string name = option ? first.substr(0, first.find('=')) : first;
    std::vector<std::string> known = option ? options_of(app) : commands_of(app);
    if (std::ranges::find(known, name) == known.end())
        throw UserError(there_is_no(option ? "option" : "command", name, known,
                                    fmt::format("say {} --help for those there are", program_name())));
}

/// Of arguments that no option takes. Throws UserError.
[[noreturn]] void refuse_extras(const CLI::App& app) {
    auto chosen = app.get_subcommands();
    const CLI::App& command = chosen.empty() ? app : *chosen.front();
    std::string name = program_name() + (chosen.empty() ? "" : " " + command.get_name());
    std::vector<std::string> extras = command.remaining();
    auto option =
        std::ranges::find_if(extras, [](const std::string& each) { return each.size() > 1 && each[0] == '-'; });
    if (option != extras.end())
        throw UserError(there_is_no("option", option->substr(0, option->find('=')), options_of(command),
                                    fmt::format("say {} --help for those there are", name)));
    throw UserError(fmt::format("{} takes no further argument: \"{}\"", name, extras.empty() ? "" : extras.front()));
}

/// Parses the command line. What it chose is then in `chosen`, or it was wrong, or asked for help.
ExitCode parse(CLI::App& app, int argc, char** argv) {
    try {
        app.parse(argc, argv);
        return ExitCode::success;
    } catch (const CLI::ExtrasError&) {
        refuse_extras(app);
    } catch (const CLI::ParseError& error) {
        std::ostringstream help, wrong;
        bool asked_for_help = app.exit(error, help, wrong) == 0;
        print_out(help.str());
        fmt::print(stderr, "{}", painted(Paint::error, wrong.str()));
        return asked_for_help ? ExitCode::success : ExitCode::bad_input;
    }
}

/// What the command line asks for. Throws what the command throws.
ExitCode execute(CLI::App& app, const Action& chosen, int argc, char** argv) {
    if (argc > 1)
        require_command(app, argv[1]);
    ExitCode parsed = parse(app, argc, argv);
    return chosen ? chosen() : parsed;
}

ExitCode report_defect(const char* what) {
    fmt::print(stderr,
               "{} defect of PlacedPar: {}\n"
               "please report it, with the command and the files that it was given\n",
               painted(Paint::error, program_name() + ":"), what);
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
        fmt::print(stderr, "{} {}\n", painted(Paint::error, program_name() + ":"), error.what());
    } catch (const std::system_error& error) {
        fmt::print(stderr, "{} {}\n", painted(Paint::error, program_name() + ":"), error.what());
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "{} there is not enough memory\n", painted(Paint::error, program_name() + ":"));
    } catch (const std::exception& error) {
        return report_defect(error.what());
    }
    return ExitCode::bad_input;
}

bool is_set(const char* variable) {
    const char* value = std::getenv(variable);
    return value && *value != '\0';
}

/// Colours are for terminals, and for users who do not forbid them (no-color.org).
void choose_paint() {
    const char* terminal = std::getenv("TERM");
    bool wanted = !is_set("NO_COLOR") && !(terminal && std::string_view(terminal) == "dumb");
    set_painted(PaintedStream::errors, wanted && ::isatty(STDERR_FILENO) != 0);
    set_painted(PaintedStream::output, wanted && ::isatty(STDOUT_FILENO) != 0);
}

} // namespace

const std::string& program_name() { return name_of_program(); }

int carry_out(CLI::App& app, std::vector<Command> commands, int argc, char** argv) {
    choose_paint();
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
