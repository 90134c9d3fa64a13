#pragma once

#include "gaprocs/problem_family.hpp"
#include "gaprocs/search_problem.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

/// A search problem and the record of measurement it is searched over: none for an objective problem. Not thread-safe:
/// the first record() may make it.
class RecordedProblem {
public:
    /// Throws std::invalid_argument: a sample has not as many numbers as the problem has channels, or an objective
    /// problem has a record.
    RecordedProblem(std::shared_ptr<const SearchProblem> problem, std::vector<Sample> record);
    RecordedProblem(std::shared_ptr<const SearchProblem> problem, RecordToMake record)
        : problem_(std::move(problem)), samples_(record.samples), advice_(record.advice),
          make_(std::move(record.make)) {}

    const std::shared_ptr<const SearchProblem>& problem() const { return problem_; }
    /// The length of the record, which need not be made for it.
    std::size_t samples() const { return samples_; }
    const RecordAdvice& advice() const { return advice_; }
    /// In order of time. The first call makes the record if it was added by add_to_make(); it then throws
    /// std::invalid_argument as the constructor, or UserError when there are not as many samples as promised.
    const std::vector<Sample>& record() const;

private:
    void take(std::vector<Sample> record) const;

    std::shared_ptr<const SearchProblem> problem_;
    std::size_t samples_;
    RecordAdvice advice_;
    mutable std::function<std::vector<Sample>()> make_; ///< empty once the record is there
    mutable std::vector<Sample> record_;
};

/// The problems that a netlist may name: `problem = "boom"`. Filled before a run. Finding a problem makes no record: a
/// process makes it by reading it.
class ProblemRegistry {
public:
    /// `record`: the samples, or how to make them. Throws std::invalid_argument: empty or repeated name, no problem,
    /// or a sample that has not as many numbers as the problem has channels.
    void add(std::string name, std::shared_ptr<const SearchProblem> problem, std::vector<Sample> record = {});
    void add_to_make(std::string name, std::shared_ptr<const SearchProblem> problem, RecordToMake record);

    /// Problems that are made when they are asked for by name and numbers: "sphere", "sphere(3)", "sphere(bits = 20)".
    /// Throws std::invalid_argument for an empty or repeated name.
    void add(ProblemFamily family);

    /// Throws UserError: there is no such problem (it names those there are), its numbers are wrong, or it cannot be
    /// made with them. The reference lives as long as the registry.
    const RecordedProblem& find(std::string_view name) const;

    /// Returns the names in alphabetical order; a family is listed by its name without numbers.
    std::vector<std::string> names() const;
    /// In alphabetical order.
    std::vector<PolicyDescription> families() const;

private:
    template <class Record>
    void add_recorded(std::string name, std::shared_ptr<const SearchProblem> problem, Record record);
    void require_new(const std::string& name) const;
    const RecordedProblem& make(const ProblemFamily& family, std::string_view text) const;

    std::map<std::string, RecordedProblem, std::less<>> problems_;
    std::map<std::string, ProblemFamily, std::less<>> families_;
    mutable std::map<std::string, RecordedProblem> made_; ///< problems of families, by their full text
};

} // namespace placedpar
