#include "app/command.hpp"
#include "app/options/common_options.hpp"
#include "app/standard_error.hpp"
#include "explore/problems.hpp"
#include "gaprocs/front_search.hpp"
#include "picture/plot.hpp"
#include "text/output_file.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>

namespace placedpar {

namespace {

struct FrontOptions {
    std::string problem, coding = "real", out = "-", svg;
    std::uint64_t generations = 250, population = 100, seed = 1;
};

/// Prints a row for each individual: its objectives, then its parameters. If the individual codes no numbers, its
/// string stands in place of the parameters.
std::string front_csv(const SearchProblem& problem, const std::vector<std::string>& objectives,
                      const FrontResult& result) {
    const auto line = [](const auto& values) { return fmt::format("{}", fmt::join(values, ",")); };
    const std::vector<std::string> names = problem.parameter_names();
    std::string out = line(objectives) + "," + (names.empty() ? "string" : line(names)) + "\n";
    for (const FrontIndividual& each : result.front)
        out += line(each.objectives) + "," +
               (names.empty() ? problem.representation().text(each.genome) : line(each.parameters)) + "\n";
    return out;
}

std::string front_svg(const std::string& title, const std::vector<std::string>& objectives, const FrontResult& result) {
    Series series{.name = fmt::format("front of {}", result.front.size()), .stroke = Stroke::points};
    for (const FrontIndividual& each : result.front)
        series.points.push_back({each.objectives[0], each.objectives[1]});
    return draw_svg({title, {{.x = {.label = objectives[0]}, .y = {.label = objectives[1]}, .series = {series}}}});
}

Coding coding_of(const FrontOptions& options) {
    try {
        return Coding::named(options.coding);
    } catch (const UserError& error) {
        throw UserError(fmt::format("--coding \"{}\": {}", options.coding, error.what()));
    }
}

ExitCode find_front(const FrontOptions& options) {
    const ProblemRegistry problems = known_problems(options.seed);
    const auto problem = problems.find(options.problem).problem()->coded(coding_of(options));
    std::vector<std::string> objectives = problem->objective_names();
    if (!options.svg.empty() && objectives.size() != 2)
        throw UserError(fmt::format("--svg draws the front of a problem with two objectives, but {} has {}",
                                    options.problem, std::max<std::size_t>(objectives.size(), 1)));
    if (objectives.empty())
        objectives = {"objective"};
    for (const std::string& file : {options.out, options.svg})
        if (!file.empty())
            require_writable(file);
    require_apart(std::array<std::filesystem::path, 2>{options.out, options.svg}, "");
    const FrontResult result =
        search_front(*problem, options.generations, front_settings(problem->representation(), 2 * options.population),
                     RandomStream(options.seed, "front"));
    write_whole(options.out, front_csv(*problem, objectives, result));
    if (result.front.empty())
        print_warnings(fmt::format("warning: no individual is feasible; the least violation of the constraints is {}\n",
                                   result.least_violation));
    else if (!options.svg.empty())
        write_whole(options.svg, front_svg(options.problem, objectives, result));
    return ExitCode::success;
}

Action declare_front(Options& command, const std::string&) {
    auto options = std::make_shared<FrontOptions>();
    command.add("PROBLEM", options->problem, "a problem that \"kinds problems\" lists, such as zdt1").required();
    add_number(command, "--generations", options->generations, 1, 1'000'000, "number of generations").show_default();
    add_number(command, "--population", options->population, 2, 100'000,
               "number of individuals that survive each generation")
        .show_default();
    command.add("--coding", options->coding, "coding of numbers in strings: natural, gray or real").show_default();
    add_seed(command, options->seed);
    add_file(command, "-o,--out", options->out, "writes the front to this file; default: standard output");
    add_file(command, "--svg", options->svg, "draws the front of two objectives to this file");
    return [options] { return find_front(*options); };
}

} // namespace

extern const Command front_command{
    .name = "front",
    .about = "Finds the Pareto front of a problem with several objectives by NSGA-II, and prints it as CSV",
    .place = 25,
    .declare = declare_front,
    .values = [] { return known_problems(0).names(); },
};

} // namespace placedpar
