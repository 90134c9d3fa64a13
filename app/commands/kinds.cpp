#include "app/command.hpp"
#include "text/output_file.hpp"
#include "workbench/kinds_choice.hpp"
#include "workbench/kinds_report.hpp"
#include "workbench/manifest.hpp"
#include "workbench/problems.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

namespace placedpar {

namespace {

std::string list_kinds(const Catalogue& catalogue) {
    return print_kinds(catalogue) +
           fmt::format(
               "\nsay {} kinds NAME for ports, parameters and measures, or a device's attributes; --json for all "
               "of it\n",
               program_name());
}

struct KindsOptions {
    std::string name;
    bool json = false;
};

ExitCode kinds(const KindsOptions& options) {
    ProblemRegistry problems = known_problems(0);
    Catalogue catalogue = known_kinds(problems);
    std::string name = known_name(catalogue, options.name);
    print_out(options.json   ? print_pretty(kinds_json(catalogue, name))
              : name.empty() ? list_kinds(catalogue)
                             : print_kind(catalogue, name));
    return ExitCode::success;
}

std::vector<std::string> names_of_kinds() {
    ProblemRegistry problems = known_problems(0);
    return known_names(known_kinds(problems));
}

Action declare_kinds(CLI::App& command, const std::string&) {
    auto options = std::make_shared<KindsOptions>();
    command.add_option("NAME", options->name, "a kind: everything about it; a group, such as csp: its kinds");
    command.add_flag("--json", options->json, "prints everything about them for machines");
    return [options] { return kinds(*options); };
}

} // namespace

extern const Command kinds_command{
    .name = "kinds",
    .about = "Lists the kinds of processes and devices that a netlist can use",
    .place = 4,
    .declare = declare_kinds,
    .values = names_of_kinds,
};

} // namespace placedpar
