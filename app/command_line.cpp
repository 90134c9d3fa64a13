#include "app/command_line.hpp"

#include "text/standard_output.hpp"
#include "text/user_error.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace placedpar {

namespace {

bool is_command(const CLI::App& app, std::string_view name) {
    return std::ranges::any_of(app.get_subcommands({}), [&](const CLI::App* each) { return each->get_name() == name; });
}

/// What the command line asks for. Throws what the command throws.
int execute(CLI::App& app, const ChosenCommand& chosen, int argc, char** argv) {
    if (argc > 1 && argv[1][0] != '-' && !is_command(app, argv[1]))
        throw std::runtime_error(
            fmt::format("there is no command \"{}\"; say placedpar --help for those there are", argv[1]));
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        std::ostringstream help, wrong;
        bool asked_for_help = app.exit(error, help, wrong) == 0;
        print_out(help.str());
        fmt::print(stderr, "{}", wrong.str());
        return static_cast<int>(asked_for_help ? ExitCode::success : ExitCode::bad_input);
    }
    return static_cast<int>(chosen());
}

} // namespace

std::string typed(int argc, char** argv) {
    std::string text = "placedpar";
    for (int i = 1; i < argc; ++i)
        text += " " + std::string(argv[i]);
    return text;
}

int carry_out(CLI::App& app, const ChosenCommand& chosen, int argc, char** argv) {
    app.name("placedpar");
    app.require_subcommand(1);
    app.footer("exit codes: 0 success, 1 wrong use or bad input, 2 deadlock, 3 a comparison missed its tolerance,\n"
               "            130 interrupted");
    try {
        return execute(app, chosen, argc, argv);
    } catch (const RefusedInput& refused) {
        fmt::print(stderr, "{}", refused.what());
    } catch (const std::exception& error) {
        fmt::print(stderr, "placedpar: {}\n", error.what());
    }
    return static_cast<int>(ExitCode::bad_input);
}

} // namespace placedpar
