#include "app/command.hpp"
#include "text/output_file.hpp"
#include "workbench/kinds_choice.hpp"
#include "workbench/kinds_report.hpp"
#include "workbench/manifest.hpp"
#include "workbench/problems.hpp"
#include "workbench/problems_report.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace placedpar {

namespace {

std::string list_kinds(const Catalogue& catalogue) {
    return print_kinds(catalogue) +
           fmt::format("\nsay {0} kinds NAME for ports, parameters and measures, or a device's attributes; --json for "
                       "all of it; {0} kinds {1} for what genetic algorithms can search for\n",
                       program_name(), problems_group);
}

/// Whether it is the name of a problem, with its numbers or without.
bool is_problem(const ProblemRegistry& problems, const std::string& name) {
    auto names = problems.names();
    return std::ranges::count(names, name.substr(0, name.find('('))) > 0;
}

std::string print_kinds_or_problems(const Catalogue& catalogue, const ProblemRegistry& problems,
                                    const std::string& name) {
    if (name.empty())
        return list_kinds(catalogue);
    if (name == problems_group)
        return print_problems(problems);
    return is_problem(problems, name) ? print_problem(problems, name)
                                      : print_kind(catalogue, known_name(catalogue, name));
}

boost::json::object json_of(const Catalogue& catalogue, const ProblemRegistry& problems, const std::string& name) {
    if (name == problems_group)
        return {{problems_group, problems_json(problems)}};
    if (is_problem(problems, name))
        return {{problems_group, boost::json::array{problem_json(problems, name)}}};
    return kinds_json(catalogue, name.empty() ? name : known_name(catalogue, name));
}

struct KindsOptions {
    std::string name;
    bool json = false;
};

ExitCode kinds(const KindsOptions& options) {
    ProblemRegistry problems = known_problems(0);
    Catalogue catalogue = known_kinds(problems);
    print_out(options.json ? print_pretty(json_of(catalogue, problems, options.name))
                           : print_kinds_or_problems(catalogue, problems, options.name));
    return ExitCode::success;
}

std::vector<std::string> names_of_kinds() {
    ProblemRegistry problems = known_problems(0);
    std::vector<std::string> names = known_names(known_kinds(problems)), searched = problems.names();
    names.emplace_back(problems_group);
    names.insert(names.end(), searched.begin(), searched.end());
    std::ranges::sort(names);
    return names;
}

Action declare_kinds(CLI::App& command, const std::string&) {
    auto options = std::make_shared<KindsOptions>();
    command.add_option(
        "NAME", options->name,
        "a kind or a search problem: everything about it; a group, such as csp: its kinds; problems: all of them");
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
