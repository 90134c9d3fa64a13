#include "app/command.hpp"
#include "app/options.hpp"
#include "app/standard_error.hpp"
#include "explore/problems.hpp"
#include "netlist/kinds/file_kinds.hpp"
#include "report/kinds_choice.hpp"
#include "report/kinds_report.hpp"
#include "report/manifest.hpp"
#include "report/policies_report.hpp"
#include "report/problems_report.hpp"
#include "text/nearest.hpp"
#include "text/output_file.hpp"
#include "text/user_error.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace placedpar {

namespace {

std::string list_kinds(const Catalogue& catalogue) {
    return print_kinds(catalogue) +
           fmt::format("\n{0} kinds NAME prints the ports, parameters and measures of a process, or the "
                       "attributes of a device.\n{0} kinds {1} lists the search problems of genetic algorithms, "
                       "{0} kinds {2} lists the policies of genetic algorithms. --json prints everything.\n",
                       program_name(), problems_group, policies_group);
}

/// Returns whether this is the name of a problem, with or without numbers in parentheses, or of a file with a problem,
/// such as "tsp:berlin52.tsp".
bool is_problem(const ProblemRegistry& problems, const std::string& name) {
    auto names = problems.names();
    const std::size_t colon = name.find(':');
    return std::ranges::count(names, name.substr(0, name.find('('))) > 0 ||
           (colon != name.npos && problems.readers().contains(name.substr(0, colon)));
}

/// Returns the names that the command accepts besides names of processes and devices.
std::vector<std::string> problems_and_policies(const ProblemRegistry& problems) {
    std::vector<std::string> names = problems.names(), policies = policy_names();
    names.emplace_back(problems_group);
    names.insert(names.end(), policies.begin(), policies.end());
    return names;
}

/// If the name is the name of a file, reads the process kind that the file defines. Returns the name by which the
/// catalogue knows the kind, or `name` if it is not the name of a file. Prints warnings. Throws RefusedInput.
std::string read_if_file(const Catalogue& catalogue, const std::string& name) {
    if (!catalogue.files()->is_file(name))
        return name;
    Reporter reporter;
    const Location typed{std::make_shared<const SourceFile>("kinds", name), 1, 1};
    std::string known = catalogue.files()->read(name, typed, {}, reporter);
    const std::string text = render(reporter.take()) + reporter.not_shown();
    if (known.empty())
        throw RefusedInput(text);
    print_error(text);
    return known;
}

enum class Meant { kinds, all_problems, problem, all_policies, policy };

/// Returns what the name stands for. Throws UserError if the name is unknown.
Meant kind_of_name(const Catalogue& catalogue, const ProblemRegistry& problems, const std::string& name) {
    auto known = known_names(catalogue);
    if (name.empty() || catalogue.find(name) || std::ranges::count(known, known_name(catalogue, name)) > 0)
        return Meant::kinds;
    if (lower_case(name) == problems_group)
        return Meant::all_problems;
    if (is_problem(problems, name))
        return Meant::problem;
    if (lower_case(name) == policies_group)
        return Meant::all_policies;
    if (is_policy(catalogue, name))
        return Meant::policy;
    refuse_kind(catalogue, name, problems_and_policies(problems));
}

std::string print_named(const Catalogue& catalogue, const ProblemRegistry& problems, const std::string& name) {
    switch (kind_of_name(catalogue, problems, name)) {
    case Meant::all_problems: return print_problems(problems);
    case Meant::problem: return print_problem(problems, name);
    case Meant::all_policies: return print_policies();
    case Meant::policy: return print_policy(catalogue, name);
    case Meant::kinds: break;
    }
    return name.empty() ? list_kinds(catalogue) : print_kind(catalogue, known_name(catalogue, name));
}

boost::json::object json_of(const Catalogue& catalogue, const ProblemRegistry& problems, const std::string& name) {
    switch (kind_of_name(catalogue, problems, name)) {
    case Meant::all_problems: return {{problems_group, problems_json(problems)}};
    case Meant::problem: return {{problems_group, boost::json::array{problem_json(problems, name)}}};
    case Meant::all_policies:
    case Meant::policy: return {{policies_group, policies_json(catalogue, lower_case(name))}};
    case Meant::kinds: break;
    }
    return kinds_json(catalogue, name.empty() ? name : known_name(catalogue, name));
}

struct KindsOptions {
    std::string name;
    bool json = false;
};

ExitCode kinds(const KindsOptions& options) {
    ProblemRegistry problems = known_problems(0);
    Catalogue catalogue = known_kinds(problems);
    const std::string name = read_if_file(catalogue, options.name);
    print_out(options.json ? print_pretty(json_of(catalogue, problems, name)) : print_named(catalogue, problems, name));
    return ExitCode::success;
}

std::vector<std::string> names_of_kinds() {
    ProblemRegistry problems = known_problems(0);
    std::vector<std::string> names = known_names(known_kinds(problems)), others = problems_and_policies(problems);
    names.insert(names.end(), others.begin(), others.end());
    std::ranges::sort(names);
    return names;
}

Action declare_kinds(Options& command, const std::string&) {
    auto options = std::make_shared<KindsOptions>();
    command.add("NAME", options->name,
                "a kind, a problem, a step of the search (selection) or a policy (tournament): prints its "
                "description. A group (csp, problems, policies): prints a list. A file in occam: prints the kind that "
                "its last PROC defines");
    command.add_flag("--json", options->json, "prints all descriptions as JSON");
    return [options] { return kinds(*options); };
}

} // namespace

extern const Command kinds_command{
    .name = "kinds",
    .about = "Lists the process kinds, devices, search problems and policies that a netlist can use",
    .place = 50,
    .declare = declare_kinds,
    .values = names_of_kinds,
};

} // namespace placedpar
