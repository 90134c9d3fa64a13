#include "gaprocs/problem_registry.hpp"

#include "text/user_error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>
#include <utility>

namespace placedpar {

RecordedProblem::RecordedProblem(std::shared_ptr<const SearchProblem> problem, std::vector<Sample> record)
    : problem_(std::move(problem)), samples_(record.size()) {
    take(std::move(record));
}

const std::vector<Sample>& RecordedProblem::record() const {
    if (make_) {
        take(make_());
        make_ = nullptr;
    }
    return record_;
}

void RecordedProblem::take(std::vector<Sample> record) const {
    for (std::size_t i = 0; i < record.size(); ++i)
        if (record[i].size() != problem_->channels())
            throw std::invalid_argument(
                fmt::format("sample {} has {} numbers, expected {}", i, record[i].size(), problem_->channels()));
    if (record.size() != samples_)
        throw std::logic_error(fmt::format("{} samples were made, {} were promised", record.size(), samples_));
    record_ = std::move(record);
}

template <class Record>
void ProblemRegistry::add_recorded(std::string name, std::shared_ptr<const SearchProblem> problem, Record record) {
    if (name.empty())
        throw std::invalid_argument("a search problem needs a name");
    if (!problem)
        throw std::invalid_argument(fmt::format("search problem '{}': there is none", name));
    if (problems_.contains(name))
        throw std::invalid_argument(fmt::format("search problem '{}' is named twice", name));
    try {
        problems_.emplace(name, RecordedProblem(std::move(problem), std::move(record)));
    } catch (const std::invalid_argument& unfit) {
        throw std::invalid_argument(fmt::format("search problem '{}': {}", name, unfit.what()));
    }
}

void ProblemRegistry::add(std::string name, std::shared_ptr<const SearchProblem> problem, std::vector<Sample> record) {
    add_recorded(std::move(name), std::move(problem), std::move(record));
}

void ProblemRegistry::add_to_make(std::string name, std::shared_ptr<const SearchProblem> problem, RecordToMake record) {
    add_recorded(std::move(name), std::move(problem), std::move(record));
}

const RecordedProblem& ProblemRegistry::find(std::string_view name) const {
    auto found = problems_.find(name);
    if (found == problems_.end())
        throw UserError(fmt::format("there is no search problem '{}'; known: {}", name, fmt::join(names(), ", ")));
    return found->second;
}

std::vector<std::string> ProblemRegistry::names() const {
    std::vector<std::string> all;
    for (const auto& [name, problem] : problems_)
        all.push_back(name);
    return all;
}

} // namespace placedpar
