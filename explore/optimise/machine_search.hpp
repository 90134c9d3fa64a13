#pragma once

#include "explore/optimise/trials.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace placedpar {

/// The number of machines that are infeasible for one reason.
struct Infeasible {
    std::size_t machines = 0;
    std::string said = {}; ///< full text of the reason, for the first of these machines
};

/// The machines (combinations of a netlist's settings) that one method of search has tried, in order.
struct SearchCourse {
    std::string way;                            ///< "genetic", "random", "exhaustive"
    std::vector<std::uint64_t> machines = {};   ///< the simulated machines, each once, in the order of the trials
    std::vector<Merit> merits = {};             ///< merits of `machines`, in the same order
    std::set<std::uint64_t> tried = {};         ///< `machines`, and the machines whose netlists were refused
    std::map<std::string, Infeasible> why = {}; ///< number of infeasible machines, by the first line of the reason

    /// Returns the indices of the machines that no other machine dominates (the Pareto front). With one cost, these are
    /// all machines of least cost.
    std::vector<std::size_t> front() const { return front_of(merits); }
};

struct CourseProgress {
    const SearchCourse& course;
    std::string step;   ///< "generation 3 of 20"
    std::uint64_t runs; ///< runs of this step made so far
};

/// The methods of searching for the best machine among a study's combinations of settings. The result of each method
/// depends neither on the number of threads nor on earlier runs. A method that is interrupted returns nothing.
class MachineSearch {
public:
    using Listener = std::function<void(const CourseProgress&)>;

    /// REQUIRES: the arguments outlive this object; Study::search has a value.
    MachineSearch(const Study&, const MachineSpace&, MachineTrials&, Listener);

    /// Searches with a genetic algorithm that resembles NSGA-II. Each generation is sorted by order_of(), the best
    /// machine first. The better half survives unchanged, and its offspring replace the other half. The operators are
    /// stochastic universal sampling over linear ranks, uniform crossover and mutation. If several genomes code for the
    /// same machine, all but the first count as infeasible, so the surviving half rarely contains a machine twice.
    /// Throws UserError if the study's condition holds for none of the machines drawn.
    std::optional<SearchCourse> genetic();
    /// Draws different machines for which the study's condition holds. Stops when `simulated` machines have been
    /// simulated, or nearly all such machines have been drawn.
    std::optional<SearchCourse> random(std::size_t simulated);
    /// Simulates every machine for which the study's condition holds.
    std::optional<SearchCourse> exhaustive();

private:
    std::vector<Genome> first_population();
    std::vector<std::uint64_t> draw(std::size_t machines, std::set<std::uint64_t>& drawn, RandomStream&);
    bool take(SearchCourse&, const std::vector<std::uint64_t>& machines, const std::string& step);
    std::vector<double> fitness_of(const std::vector<std::uint64_t>& machines);

    const StudySearch& wanted_;
    const MachineSpace& space_;
    MachineTrials& trials_;
    Listener listener_;
};

} // namespace placedpar
