#include "gaprocs/problem_registry.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>
#include <utility>

namespace placedpar {

void ProblemRegistry::add(std::string name, std::shared_ptr<const SearchProblem> problem, std::vector<Sample> record) {
    if (name.empty())
        throw std::invalid_argument("a search problem needs a name");
    if (!problem)
        throw std::invalid_argument(fmt::format("search problem '{}': there is none", name));
    for (std::size_t i = 0; i < record.size(); ++i)
        if (record[i].size() != problem->channels())
            throw std::invalid_argument(fmt::format("search problem '{}': sample {} has {} numbers, expected {}", name,
                                                    i, record[i].size(), problem->channels()));
    if (problems_.contains(name))
        throw std::invalid_argument(fmt::format("search problem '{}' is named twice", name));
    problems_.emplace(std::move(name), RecordedProblem{std::move(problem), std::move(record)});
}

const RecordedProblem& ProblemRegistry::find(std::string_view name) const {
    auto found = problems_.find(name);
    if (found == problems_.end())
        throw std::invalid_argument(
            fmt::format("there is no search problem '{}'; known: {}", name, fmt::join(names(), ", ")));
    return found->second;
}

std::vector<std::string> ProblemRegistry::names() const {
    std::vector<std::string> all;
    for (const auto& [name, problem] : problems_)
        all.push_back(name);
    return all;
}

} // namespace placedpar
