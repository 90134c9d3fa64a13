#include "app/command.hpp"

#include "text/nearest.hpp"
#include "text/output_file.hpp"
#include "text/user_error.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
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

/// The command line as it was typed, whatever the program's file is called.
std::string typed(int argc, char** argv) {
    std::string text = "placedpar";
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
    std::vector<std::string> commands = commands_of(app);
    if (argc > 1 && argv[1][0] != '-' && std::ranges::find(commands, argv[1]) == commands.end())
        throw UserError(there_is_no("command", argv[1], commands, "say placedpar --help for those there are"));
}

/// Of arguments that no option takes. Throws UserError.
[[noreturn]] void refuse_extras(const CLI::App& app) {
    auto chosen = app.get_subcommands();
    const CLI::App& command = chosen.empty() ? app : *chosen.front();
    std::string name = "placedpar" + (chosen.empty() ? "" : " " + command.get_name());
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
               "placedpar: defect of PlacedPar: {}\n"
               "please report it, with the command and the files that it was given\n",
               what);
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
        fmt::print(stderr, "placedpar: {}\n", error.what());
    } catch (const std::system_error& error) {
        fmt::print(stderr, "placedpar: {}\n", error.what());
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "placedpar: there is not enough memory\n");
    } catch (const std::exception& error) {
        return report_defect(error.what());
    }
    return ExitCode::bad_input;
}

} // namespace

int carry_out(CLI::App& app, std::vector<Command> commands, int argc, char** argv) {
    Action chosen;
    std::ranges::sort(commands, {}, &Command::place);
    for (const Command& command : commands)
        declare(app, command, typed(argc, argv), chosen);
    app.name("placedpar");
    app.require_subcommand(1);
    app.footer( // last: a subcommand takes over the footer that its parent has when it is added
        "exit codes: 0 success, 1 wrong use or bad input, 2 deadlock, 3 a comparison missed its tolerance,\n"
        "            70 a defect of PlacedPar, 130 interrupted");
    try {
        return static_cast<int>(execute(app, chosen, argc, argv));
    } catch (...) {
        return static_cast<int>(report_error());
    }
}

} // namespace placedpar
