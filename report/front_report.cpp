#include "report/front_report.hpp"

#include "text/user_error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>
#include <vector>

namespace placedpar {

std::string front_csv(const SearchProblem& problem, const FrontResult& result) {
    std::vector<std::string> heads = problem.objective_names();
    if (heads.empty())
        heads.emplace_back("objective");
    const std::vector<std::string> names = problem.parameter_names();
    heads.insert(heads.end(), names.begin(), names.end());
    if (names.empty())
        heads.emplace_back("string");
    std::string out = fmt::format("{}\n", fmt::join(heads, ","));
    for (const FrontIndividual& each : result.front)
        out += fmt::format("{},{}\n", fmt::join(each.objectives, ","),
                           names.empty() ? problem.representation().text(each.genome)
                                         : fmt::format("{}", fmt::join(each.parameters, ",")));
    return out;
}

void require_two_objectives(const SearchProblem& problem) {
    if (const std::size_t count = problem.objective_names().size(); count != 2)
        throw UserError(fmt::format("a plot of a front needs two objectives, but this problem has {}",
                                    count == 0 ? "one" : std::to_string(count)));
}

Plot front_plot(std::string title, const SearchProblem& problem, const FrontResult& result) {
    require_two_objectives(problem);
    const std::vector<std::string> names = problem.objective_names();
    Series series{.name = fmt::format("{} individuals", result.front.size()), .stroke = Stroke::points};
    for (const FrontIndividual& each : result.front)
        series.points.push_back({each.objectives[0], each.objectives[1]});
    if (series.points.empty())
        throw UserError("nothing to draw: no individual is feasible");
    return {std::move(title), {{.x = {.label = names[0]}, .y = {.label = names[1]}, .series = {std::move(series)}}}};
}

} // namespace placedpar
