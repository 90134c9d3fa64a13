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

/// A search problem with its record of measurements; the record of an objective problem is empty. Not thread-safe,
/// because the first call of record() may make the record.
class RecordedProblem {
public:
    /// Throws what require_channels() throws, and std::invalid_argument if an objective problem has a record.
    RecordedProblem(std::shared_ptr<const SearchProblem> problem, std::vector<Sample> record);
    RecordedProblem(std::shared_ptr<const SearchProblem> problem, RecordToMake record)
        : problem_(std::move(problem)), samples_(record.samples), advice_(record.advice),
          make_(std::move(record.make)) {}

    const std::shared_ptr<const SearchProblem>& problem() const { return problem_; }
    /// Returns the length of the record without making it.
    std::size_t samples() const { return samples_; }
    const RecordAdvice& advice() const { return advice_; }
    /// Returns the samples, oldest first. If the object was constructed with a RecordToMake, the first call makes the
    /// record. This first call throws what the constructor with a record throws, and UserError if the number of samples
    /// differs from RecordToMake::samples.
    const std::vector<Sample>& record() const;

private:
    void take(std::vector<Sample> record) const;

    std::shared_ptr<const SearchProblem> problem_;
    std::size_t samples_;
    RecordAdvice advice_;
    mutable std::function<std::vector<Sample>()> make_; ///< empty once the record has been made
    mutable std::vector<Sample> record_;
};

/// Reads problems from files of one format.
struct ProblemReader {
    std::string about; ///< one line
    /// Returns the problem in the file. Throws UserError for a file that cannot be read.
    std::function<std::shared_ptr<const SearchProblem>(const std::string& file)> read;
};

/// The problems that a netlist may name, as in `problem = "boom"`. The program adds all problems before a run. find()
/// does not make a record; the first RecordedProblem::record() makes it.
class ProblemRegistry {
public:
    /// Add a problem. `record`: the samples, or how to make them. Throw std::invalid_argument for an empty or repeated
    /// name and for a null problem, and what the constructors of RecordedProblem throw.
    void add(std::string name, std::shared_ptr<const SearchProblem> problem, std::vector<Sample> record = {});
    void add_to_make(std::string name, std::shared_ptr<const SearchProblem> problem, RecordToMake record);

    /// Adds a family, that is, problems that differ in their numbers: "sphere", "sphere(3)", "sphere(bits = 20)". The
    /// first find() with the numbers of a problem makes this problem. Throws std::invalid_argument for an empty or
    /// repeated name.
    void add(ProblemFamily family);

    /// Adds a reader of files. The first find() of "format:FILE" reads the file; a relative path is relative to the
    /// working directory.
    void add_reader(std::string format, ProblemReader reader);

    /// Returns the problem. Throws UserError if the name is unknown (the message lists the names), or if the numbers of
    /// a family are wrong or give no valid problem. The reference is valid as long as the registry exists.
    const RecordedProblem& find(std::string_view name) const;

    /// Returns the names in alphabetical order. A family is listed by its name without numbers.
    std::vector<std::string> names() const;
    /// Returns the descriptions of the families in alphabetical order.
    std::vector<PolicyDescription> families() const;
    const std::map<std::string, ProblemReader, std::less<>>& readers() const { return readers_; }

private:
    template <class Record>
    void add_recorded(std::string name, std::shared_ptr<const SearchProblem> problem, Record record);
    void require_new(const std::string& name) const;
    const RecordedProblem& make(const ProblemFamily& family, std::string_view text) const;
    const RecordedProblem* read(std::string_view name) const;

    std::map<std::string, RecordedProblem, std::less<>> problems_;
    std::map<std::string, ProblemFamily, std::less<>> families_;
    std::map<std::string, ProblemReader, std::less<>> readers_; ///< by format
    /// Problems that a family made or a reader read. The key is the name with all numbers, or "format:FILE".
    mutable std::map<std::string, RecordedProblem, std::less<>> made_;
};

} // namespace placedpar
