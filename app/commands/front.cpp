#include "app/command.hpp"
#include "app/options/common_options.hpp"
#include "app/standard_error.hpp"
#include "explore/problems.hpp"
#include "gaprocs/front_search.hpp"
#include "report/front_report.hpp"
#include "text/output_file.hpp"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <memory>

namespace placedpar {

namespace {

struct FrontOptions {
    std::string problem, coding = "real", out = "-", svg;
    std::uint64_t generations = 250, population = 100, seed = 1;
};

ExitCode find_front(const FrontOptions& options) {
    const ProblemRegistry problems = known_problems(options.seed);
    const auto problem = problems.find(options.problem).problem()->coded(Coding::named(options.coding));
    require_writable(options.out);
    require_apart(std::array<std::filesystem::path, 2>{options.out, options.svg}, "");
    if (!options.svg.empty()) {
        require_writable(options.svg);
        require_two_objectives(*problem);
    }
    const FrontResult result =
        search_front(*problem, options.generations, front_settings(problem->representation(), 2 * options.population),
                     RandomStream(options.seed, "front"));
    if (result.front.empty())
        print_warnings(fmt::format("warning: no individual is feasible; the least violation of the constraints is {}\n",
                                   result.least_violation));
    write_whole(options.out, front_csv(*problem, result));
    if (!options.svg.empty())
        write_whole(options.svg, draw_svg(front_plot(options.problem, *problem, result)));
    return ExitCode::success;
}

Action declare_front(Options& command, const std::string&) {
    auto options = std::make_shared<FrontOptions>();
    command
        .add("PROBLEM", options->problem,
             fmt::format("a problem that \"{} kinds problems\" lists, such as zdt1", program_name()))
        .check(not_a_name)
        .required();
    add_number(command, "--generations", options->generations, 1, 1'000'000, "number of generations").show_default();
    add_number(command, "--population", options->population, 2, 100'000, "individuals that survive a generation")
        .show_default();
    command.add("--coding", options->coding, "how strings code numbers: natural, gray or real").show_default();
    add_seed(command, options->seed);
    add_file(command, "-o,--out", options->out, "writes the front to this file; default: standard output");
    add_file(command, "--svg", options->svg, "draws the front of two objectives to this file");
    return [options] { return find_front(*options); };
}

std::vector<std::string> names_of_problems() { return known_problems(0).names(); }

} // namespace

extern const Command front_command{
    .name = "front",
    .about = "Searches for the front of a problem with several objectives by NSGA-II, and prints it as CSV",
    .place = 25,
    .declare = declare_front,
    .values = names_of_problems,
};

} // namespace placedpar
