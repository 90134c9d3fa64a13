#include "app/command.hpp"

#include "app/options.hpp"
#include "report/manifest.hpp"
#include "runtime/kernel.hpp"
#include "runtime/process.hpp"
#include "runtime/user_code.hpp"
#include "text/meaning.hpp"
#include "text/nearest.hpp"
#include "text/output_file.hpp"
#include "text/paint.hpp"
#include "text/standard_streams.hpp"
#include "text/user_error.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <new>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>

namespace placedpar {

namespace {

std::vector<Command>& commands_of_program() {
    static std::vector<Command> all;
    return all;
}

/// Returns the version text. The text also names the program, because a user's own program may have its own version.
std::string version_of_program() {
    return program_name() == "placedpar" ? "placedpar " + version_text()
                                         : fmt::format("{} (PlacedPar {})", program_name(), version_text());
}

/// Returns the command line as typed, without the path of the program.
std::string typed(int argc, char** argv) {
    std::string text = program_name();
    for (int i = 1; i < argc; ++i)
        text += " " + std::string(argv[i]);
    return text;
}

void declare(CLI::App& app, const Command& command, const std::string& command_line, Action& chosen) {
    CLI::App* subcommand = app.add_subcommand(command.name, command.about);
    Options options(*subcommand);
    Action action = command.declare(options, command_line);
    subcommand->callback([&chosen, action] { chosen = action; });
}

bool is_file(const std::string& name) {
    std::error_code error;
    return lower_case(name).ends_with(".cfs") || std::filesystem::is_regular_file(name, error);
}

/// Returns the command that a user probably meant, for a suggestion. The first word may be a command of many other
/// programs (help, version) or the name of a file; for other words, returns "".
std::string meant_by(const DeclaredCommand& program, std::span<char*> words) {
    std::string first = words.front();
    if (first == "help")
        return words.size() > 1 && program.command(words[1]) ? fmt::format("{} --help", words[1]) : "--help";
    if (first == "version")
        return "--version";
    return is_file(first) && program.command("run") ? "run " + first : "";
}

std::vector<NamedMeaning> meanings_of_commands(const DeclaredCommand& program) {
    std::vector<NamedMeaning> meanings;
    for (const DeclaredCommand& each : program.commands)
        meanings.push_back({each.name, each.about});
    return meanings;
}

/// Throws UserError if the first word is not a command. CLI11 would only report that a command is missing.
void require_command(const DeclaredCommand& program, std::span<char*> words) {
    std::string first = words.front();
    bool option = first.starts_with('-');
    std::string name = option ? first.substr(0, first.find('=')) : first;
    const std::vector<std::string> known = option ? program.names_of_options() : program.names_of_commands();
    if (std::ranges::find(known, name) != known.end())
        return;
    if (std::string meant = meant_by(program, words); !meant.empty())
        throw UserError(fmt::format("unknown command \"{}\"; did you mean {} {}?", name, program_name(), meant));
    if (option)
        throw UserError(
            unknown_name("option", name, known, fmt::format("{} --help lists the options", program_name())));
    throw UserError(unknown_meaning("command", name, meanings_of_commands(program),
                                    fmt::format("{} --help lists the commands", program_name())));
}

bool takes_option(const DeclaredCommand& command, const std::string& name) { return command.option(name) != nullptr; }

bool takes_settings_as_arguments(const DeclaredCommand& command) {
    return std::ranges::find(command.options, "SETTING", &DeclaredOption::label) != command.options.end();
}

/// Returns a sentence about how this command sets a value of the netlist, for users who typed the value in another way.
/// Returns "" if the command sets no values.
std::string how_to_set(const DeclaredCommand& command, const std::string& setting) {
    if (takes_settings_as_arguments(command))
        return fmt::format("values of the netlist are set without an option: {}", setting);
    return takes_option(command, "--set") ? fmt::format("a value of the netlist is set by --set {}", setting) : "";
}

[[noreturn]] void refuse_option(const DeclaredCommand& command, const std::string& typed, const std::string& whose) {
    const std::string option = typed.substr(0, typed.find('='));
    if (option == "--set" && takes_settings_as_arguments(command))
        throw UserError(
            fmt::format("{} has no option --set; leave it out: settings are arguments, such as slaves=0..7", whose));
    const std::string name = option.substr(std::min(option.find_first_not_of('-'), option.size()));
    const bool is_name = !name.empty() && std::isalpha(static_cast<unsigned char>(name.front()));
    std::string otherwise = is_name ? how_to_set(command, name + "=VALUE") : "";
    otherwise += fmt::format("{}{} --help lists the options", otherwise.empty() ? "" : "; ", whose);
    throw UserError(unknown_name("option", option, command.names_of_options(), otherwise));
}

[[noreturn]] void refuse_argument(const DeclaredCommand& command, const std::string& argument,
                                  const std::string& whose) {
    const std::string hint = argument.find('=') == std::string::npos ? "" : how_to_set(command, argument);
    throw UserError(
        fmt::format("{} takes no further argument: \"{}\"{}{}", whose, argument, hint.empty() ? "" : "; ", hint));
}

/// Throws UserError for arguments that no option takes.
[[noreturn]] void refuse_extras(const CLI::App& app) {
    auto chosen = app.get_subcommands();
    const CLI::App& command = chosen.empty() ? app : *chosen.front();
    std::string name = program_name() + (chosen.empty() ? "" : " " + command.get_name());
    std::vector<std::string> extras = command.remaining();
    auto option =
        std::ranges::find_if(extras, [](const std::string& each) { return each.size() > 1 && each[0] == '-'; });
    if (option != extras.end())
        refuse_option(declared(command), *option, name);
    refuse_argument(declared(command), extras.empty() ? "" : extras.front(), name);
}

/// Throws UserError for an option that takes one value but was given several.
void refuse_repeated(const CLI::App& app) {
    for (const CLI::App* command : app.get_subcommands())
        for (const CLI::Option* option : command->get_options())
            if (option->get_items_expected_max() > 0 &&
                option->results().size() > static_cast<std::size_t>(option->get_items_expected_max()))
                throw UserError(fmt::format("{} takes one value, but was given {} times ({})", option->get_name(),
                                            option->results().size(), fmt::join(option->results(), ", ")));
}

/// Parses the command line, which selects the action. Prints help or an error and returns the exit code.
ExitCode parse(CLI::App& app, int argc, char** argv) {
    try {
        app.parse(argc, argv);
        return ExitCode::success;
    } catch (const CLI::ExtrasError&) {
        refuse_extras(app);
    } catch (const CLI::ParseError& error) {
        if (dynamic_cast<const CLI::ArgumentMismatch*>(&error))
            refuse_repeated(app);
        std::ostringstream help, wrong;
        bool asked_for_help = app.exit(error, help, wrong) == 0;
        print_out(help.str());
        print_error(painted(Paint::error, wrong.str()));
        return asked_for_help ? ExitCode::success : ExitCode::bad_input;
    }
}

void declare_all(CLI::App& app, const std::vector<Command>& commands, const std::string& command_line, Action& chosen) {
    for (const Command& command : commands)
        declare(app, command, command_line, chosen);
    app.require_subcommand(1);
}

/// Parses as parse() does, but first throws UserError for an unknown command.
ExitCode read(CLI::App& app, int argc, char** argv) {
    if (argc > 1)
        require_command(declared(app), std::span(argv, static_cast<std::size_t>(argc)).subspan(1));
    return parse(app, argc, argv);
}

ExitCode report_defect(const std::string& what) {
    print_error(fmt::format("{} defect of PlacedPar: {}\nplease report it, with the command and its input files\n",
                            painted(Paint::error, program_name() + ":"), what));
    return ExitCode::defect;
}

std::string what_is_running() {
    const Kernel* kernel = Kernel::current();
    const Process* process = kernel ? kernel->who_runs() : nullptr;
    return process ? fmt::format("process {} at {}", process->path(), to_string(kernel->now())) : "the program";
}

std::string why_it_is_terminated() {
    try {
        return std::current_exception() ? what_was_thrown() : "std::terminate was called";
    } catch (...) {
        return "the process communicated, computed or waited while it was being terminated";
    }
}

/// Reports an exception that no handler can catch, because it left a destructor or a noexcept function.
[[noreturn]] void report_termination() {
    const char* left = std::current_exception() ? "; the exception left a destructor or a noexcept function" : "";
    std::string what = fmt::format("{}: {}{}", what_is_running(), why_it_is_terminated(), left);
    if (program_name() == "placedpar")
        std::_Exit(static_cast<int>(report_defect(what)));
    print_error(fmt::format("{} {}\n", painted(Paint::error, program_name() + ":"), what));
    std::_Exit(static_cast<int>(ExitCode::bad_input));
}

/// Reports the exception being handled. UserErrors and errors of the system, such as a lack of memory, are not defects.
/// Any other exception is a defect.
ExitCode report_error() {
    try {
        throw;
    } catch (const RefusedInput& refused) {
        print_error(refused.what());
    } catch (const UserError& error) {
        print_error(fmt::format("{} {}\n", painted(Paint::error, program_name() + ":"), error.what()));
    } catch (const std::system_error& error) {
        print_error(fmt::format("{} {}\n", painted(Paint::error, program_name() + ":"), error.what()));
    } catch (const std::bad_alloc&) {
        print_error(fmt::format("{} there is not enough memory\n", painted(Paint::error, program_name() + ":")));
    } catch (...) {
        return report_defect(what_was_thrown());
    }
    return ExitCode::bad_input;
}

bool is_set(const char* variable) {
    const char* value = std::getenv(variable);
    return value && *value != '\0';
}

/// Enables colours on terminals, unless the user forbids them (no-color.org).
void choose_paint() {
    const char* terminal = std::getenv("TERM");
    bool wanted = !is_set("NO_COLOR") && !(terminal && std::string_view(terminal) == "dumb");
    set_painted(PaintedStream::errors, wanted && ::isatty(STDERR_FILENO) != 0);
    set_painted(PaintedStream::output, wanted && ::isatty(STDOUT_FILENO) != 0);
}

} // namespace

const std::vector<Command>& commands() { return commands_of_program(); }

void read_command_line(const std::vector<Command>& commands, int argc, char** argv) {
    CLI::App app("", program_name());
    Action chosen;
    declare_all(app, commands, typed(argc, argv), chosen);
    read(app, argc, argv);
}

int carry_out(Program program, int argc, char** argv, const std::function<void()>& begin) {
    hold_closed_streams();
    choose_paint();
    std::set_terminate(report_termination);
    std::signal(SIGPIPE, SIG_IGN);
    if (!program.name.empty())
        set_program_name(program.name);
    std::ranges::sort(program.commands, {}, &Command::place);
    commands_of_program() = program.commands;
    CLI::App app(program.about, program_name());
    Action chosen;
    declare_all(app, program.commands, typed(argc, argv), chosen);
    app.set_version_flag("-v,-V,--version", version_of_program());
    app.footer( // set last, because each new subcommand would inherit the footer
        "The file name - stands for standard input, if a command reads it, or for standard output.\nexit codes: 0 "
        "success, 1 wrong use or "
        "bad input, 2 deadlock, 3 a comparison missed its tolerance,\n            70 a defect of PlacedPar, 130 "
        "interrupted");
    try {
        begin();
        ExitCode parsed = read(app, argc, argv);
        return static_cast<int>(chosen ? chosen() : parsed);
    } catch (...) {
        return static_cast<int>(report_error());
    }
}

} // namespace placedpar
