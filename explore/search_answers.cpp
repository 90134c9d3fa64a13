#include "explore/search_answers.hpp"

#include "gaprocs/search_problem.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace placedpar {

SearchAnswers::SearchAnswers(std::vector<std::string> searches, std::shared_ptr<const SearchProblem> problem)
    : searches_(std::move(searches)), problem_(std::move(problem)), answers_(searches_.size()) {}

void SearchAnswers::observe(const ObservedGeneration& generation) {
    auto search = std::ranges::find(searches_, generation.search);
    if (search == searches_.end())
        throw std::invalid_argument("the search of this generation is unknown");
    auto best = std::ranges::max_element(generation.fitness);
    const Genome& genome = generation.population[static_cast<std::size_t>(best - generation.fitness.begin())];
    answers_[static_cast<std::size_t>(search - searches_.begin())].push_back(
        {generation.time.value_or(Time{}), *best, problem_->decode(genome)});
}

std::size_t SearchAnswers::generations() const {
    auto fewest = std::ranges::min_element(answers_, {}, [](const auto& answers) { return answers.size(); });
    return fewest == answers_.end() ? 0 : fewest->size();
}

std::size_t SearchAnswers::fittest(std::size_t generation) const {
    auto fitness = [&](const std::vector<SearchAnswer>& answers) { return answers[generation].fitness; };
    return static_cast<std::size_t>(std::ranges::max_element(answers_, {}, fitness) - answers_.begin());
}

double SearchAnswers::spread(std::size_t generation, std::size_t parameter) const {
    auto value = [&](const std::vector<SearchAnswer>& answers) { return answers[generation].values[parameter]; };
    auto [least, greatest] = std::ranges::minmax_element(answers_, {}, value);
    return value(*greatest) - value(*least);
}

Time SearchAnswers::ready(std::size_t generation) const {
    auto time = [&](const std::vector<SearchAnswer>& answers) { return answers[generation].time; };
    return time(*std::ranges::max_element(answers_, {}, time));
}

} // namespace placedpar
