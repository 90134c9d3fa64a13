#pragma once

#include "gaprocs/search_problem.hpp"

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

/// A search problem and the record of measurement it is searched over.
struct RecordedProblem {
    std::shared_ptr<const SearchProblem> problem;
    std::vector<Sample> record; // in order of time
};

/// The problems that a netlist may name: `problem = "boom"`. Filled before a run by whoever knows the
/// problems.
class ProblemRegistry {
public:
    /// Throws std::invalid_argument: empty or repeated name, no problem, or a sample of the record that has
    /// not as many numbers as the problem has channels.
    void add(std::string name, std::shared_ptr<const SearchProblem> problem, std::vector<Sample> record);

    /// Throws std::invalid_argument, naming the problems there are. The reference lives as long as the
    /// registry.
    const RecordedProblem& find(std::string_view name) const;

    /// In alphabetical order.
    std::vector<std::string> names() const;

private:
    std::map<std::string, RecordedProblem, std::less<>> problems_;
};

} // namespace placedpar
