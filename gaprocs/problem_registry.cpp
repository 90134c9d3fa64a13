#include "gaprocs/problem_registry.hpp"

#include "gaprocs/usual_settings.hpp"
#include "text/nearest.hpp"
#include "text/user_error.hpp"

#include <boost/algorithm/string/trim.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace placedpar {

RecordedProblem::RecordedProblem(std::shared_ptr<const SearchProblem> problem, std::vector<Sample> record)
    : problem_(std::move(problem)), samples_(record.size()) {
    take(std::move(record));
}

const std::vector<Sample>& RecordedProblem::record() const {
    if (make_) {
        std::vector<Sample> made = make_();
        if (made.size() != samples_)
            throw UserError(fmt::format("RecordToMake::samples is {}, but the number of samples that make() returned "
                                        "is {}: the two numbers must be equal",
                                        samples_, made.size()));
        take(std::move(made));
        make_ = nullptr;
    }
    return record_;
}

void RecordedProblem::take(std::vector<Sample> record) const {
    if (problem_->objective() && !record.empty())
        throw std::invalid_argument("an objective problem has no record");
    require_channels(*problem_, record);
    record_ = std::move(record);
}

void ProblemRegistry::require_new(const std::string& name) const {
    if (name.empty())
        throw std::invalid_argument("a search problem needs a name");
    if (problems_.contains(name) || families_.contains(name))
        throw std::invalid_argument(fmt::format("a search problem named '{}' exists already", name));
}

template <class Record>
void ProblemRegistry::add_recorded(std::string name, std::shared_ptr<const SearchProblem> problem, Record record) {
    require_new(name);
    if (!problem)
        throw std::invalid_argument(fmt::format("search problem '{}': the problem is a null pointer", name));
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

void ProblemRegistry::add(ProblemFamily family) {
    require_new(family.description.name);
    std::string name = family.description.name;
    families_.emplace(std::move(name), std::move(family));
}

void ProblemRegistry::add_reader(std::string format, ProblemReader reader) {
    readers_.emplace(std::move(format), std::move(reader));
}

/// If `name` is "format:FILE", and a reader has this format, returns the problem in the file; otherwise null.
const RecordedProblem* ProblemRegistry::read(std::string_view name) const {
    const std::size_t colon = name.find(':');
    const auto reader = readers_.find(name.substr(0, colon));
    if (colon == name.npos || reader == readers_.end())
        return nullptr;
    if (colon + 1 == name.size())
        throw UserError(
            fmt::format("the problem \"{0}\" names no file: expected {0}FILE, {1}", name, reader->second.about));
    auto found = made_.find(name);
    if (found == made_.end())
        found = made_
                    .emplace(name, RecordedProblem(reader->second.read(std::string(name.substr(colon + 1))),
                                                   std::vector<Sample>()))
                    .first;
    return &found->second;
}

const RecordedProblem& ProblemRegistry::find(std::string_view name) const {
    if (auto found = problems_.find(name); found != problems_.end())
        return found->second;
    auto family = families_.find(boost::algorithm::trim_copy(name.substr(0, name.find('('))));
    if (family != families_.end())
        return make(family->second, name);
    if (const RecordedProblem* from_file = read(name))
        return *from_file;
    std::string guess = did_you_mean(name, names());
    throw UserError(fmt::format("unknown search problem '{}'; known: {}{}", name, fmt::join(names(), ", "),
                                guess.empty() ? "" : "; " + guess));
}

/// Returns the problem of the family that `text` names; makes the problem at the first call. An error message contains
/// the problem's name with all its numbers.
const RecordedProblem& ProblemRegistry::make(const ProblemFamily& family, std::string_view text) const {
    std::vector<double> numbers = read_policy(text, {family.description}).numbers;
    std::string full = family.description.text(numbers);
    if (auto found = made_.find(full); found != made_.end())
        return found->second;
    try {
        RecordToMake record = family.record ? family.record(numbers) : RecordToMake{};
        return made_.emplace(full, RecordedProblem(family.make(numbers), std::move(record))).first->second;
    } catch (const std::invalid_argument& unfit) {
        throw UserError(fmt::format("search problem '{}': {}", full, unfit.what()));
    }
}

std::vector<std::string> ProblemRegistry::names() const {
    std::vector<std::string> all;
    for (const auto& [name, problem] : problems_)
        all.push_back(name);
    for (const auto& [name, family] : families_)
        all.push_back(name);
    std::ranges::sort(all);
    return all;
}

std::vector<PolicyDescription> ProblemRegistry::families() const {
    std::vector<PolicyDescription> all;
    for (const auto& [name, family] : families_)
        all.push_back(family.description);
    return all;
}

} // namespace placedpar
