#include "gaprocs/usual_settings.hpp"

#include "text/counted.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace placedpar {

SearchSettings usual_settings(const SearchProblem& problem) {
    SearchSettings settings;
    if (problem.objective())
        settings.reproduction = RankingReproduction{};
    switch (problem.representation().kind()) {
    case StringKind::binary: break;
    case StringKind::real:
        settings.crossover = BlendCrossover{};
        settings.mutation = GaussianMutation{};
        break;
    case StringKind::permutation: settings.crossover = OrderCrossover{}; settings.mutation = InversionMutation{};
    }
    return settings;
}

SearchSettings settings_for(const SearchProblem& problem, SearchSettings settings) {
    require_fitting_reproduction(problem, settings.reproduction);
    require_fitting_operators(problem.representation(), settings);
    if (problem.objective())
        settings.window = {.length = 1, .first = 1, .trials = 1};
    return settings;
}

void require_fitting_reproduction(const SearchProblem& problem, const Reproduction& reproduction) {
    auto objective = problem.objective();
    if (objective && objective->goal == Goal::minimise && reproduction.needs_positive_fitness())
        throw UserError(
            fmt::format("reproduction by {} discards individuals with fitness <= 0, but the fitness of a minimised "
                        "objective is the negated objective: expected ranking, scaled or tournament",
                        reproduction.text()));
}

void require_channels(const SearchProblem& problem, std::span<const Sample> record) {
    for (std::size_t i = 0; i < record.size(); ++i)
        if (record[i].size() != problem.channels())
            throw std::invalid_argument(fmt::format("sample {} has {}, expected {}", i,
                                                    counted(record[i].size(), "number"), problem.channels()));
}

std::vector<Sample> empty_record(std::size_t generations) {
    if (generations == 0)
        throw UserError("the number of generations is 0, expected at least 1");
    return std::vector<Sample>(generations);
}

} // namespace placedpar
