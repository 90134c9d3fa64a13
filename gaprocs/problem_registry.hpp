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

/// A search problem with its record of measurement; an objective problem has none. Not thread-safe: the first call of
/// record() may make the record.
class RecordedProblem {
public:
    /// Throws std::invalid_argument if a sample does not have one number for each channel of the problem, or an
    /// objective problem has a record.
    RecordedProblem(std::shared_ptr<const SearchProblem> problem, std::vector<Sample> record);
    RecordedProblem(std::shared_ptr<const SearchProblem> problem, RecordToMake record)
        : problem_(std::move(problem)), samples_(record.samples), advice_(record.advice),
          make_(std::move(record.make)) {}

    const std::shared_ptr<const SearchProblem>& problem() const { return problem_; }
    /// Returns the length of the record without making it.
    std::size_t samples() const { return samples_; }
    const RecordAdvice& advice() const { return advice_; }
    /// Returns the samples in order of time. The first call makes the record if it was added by add_to_make(); that
    /// call throws std::invalid_argument as the constructor, or UserError if the number of samples differs from
    /// RecordToMake::samples.
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
    /// `record`: the samples, or how to make them. Throws std::invalid_argument: empty or repeated name, no problem, or
    /// a sample that does not have one number for each channel of the problem.
    void add(std::string name, std::shared_ptr<const SearchProblem> problem, std::vector<Sample> record = {});
    void add_to_make(std::string name, std::shared_ptr<const SearchProblem> problem, RecordToMake record);

    /// Adds problems that are made when they are first found by name and numbers: "sphere", "sphere(3)", "sphere(bits =
    /// 20)". Throws std::invalid_argument for an empty or repeated name.
    void add(ProblemFamily family);

    /// Returns the problem. Throws UserError if it does not exist (the message lists the problems that do), its numbers
    /// are wrong, or it cannot be made with them. The reference lives as long as the registry.
    const RecordedProblem& find(std::string_view name) const;

    /// Returns the names in alphabetical order; a family is listed by its name without numbers.
    std::vector<std::string> names() const;
    /// Returns the descriptions of the families in alphabetical order.
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
