#include "app/program.hpp"

#include "app/command.hpp"
#include "workbench/problems.hpp"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <utility>

namespace placedpar {

extern const Command run_command, explain_command, check_command, show_command, kinds_command, sweep_command,
    report_command;

int run_program(int argc, char** argv, std::vector<ProcessKind> own_kinds, std::vector<ProblemFamily> own_problems) {
    add_own_kinds(std::move(own_kinds));
    add_own_problems(std::move(own_problems));
    CLI::App app{"Runs, checks, shows and studies netlists.", std::filesystem::path(argv[0]).filename().string()};
    return carry_out(
        app, {run_command, explain_command, check_command, show_command, kinds_command, sweep_command, report_command},
        argc, argv);
}

} // namespace placedpar
