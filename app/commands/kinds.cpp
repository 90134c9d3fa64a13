#include "app/command.hpp"
#include "text/output_file.hpp"
#include "workbench/kinds_report.hpp"
#include "workbench/problems.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace placedpar {

namespace {

std::string list_kinds(const Catalogue& catalogue) {
    return print_kinds(catalogue) +
           fmt::format("\nsay {} kinds NAME for ports, parameters and measures, or a device's attributes\n",
                       program_name());
}

ExitCode kinds(const std::string& name) {
    ProblemRegistry problems = known_problems(0);
    Catalogue catalogue = known_kinds(problems);
    print_out(name.empty() ? list_kinds(catalogue) : print_kind(catalogue, name));
    return ExitCode::success;
}

Action declare_kinds(CLI::App& command, const std::string&) {
    auto name = std::make_shared<std::string>();
    command.add_option("NAME", *name, "everything about this kind");
    return [name] { return kinds(*name); };
}

} // namespace

extern const Command kinds_command{
    .name = "kinds",
    .about = "Lists the kinds of processes and devices that a netlist can use",
    .place = 4,
    .declare = declare_kinds,
};

} // namespace placedpar
