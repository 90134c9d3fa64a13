#pragma once

#include "explore/optimise/machine_search.hpp"
#include "explore/study/results.hpp"
#include "explore/study/summary.hpp"
#include "observe/critical_path/critical_path.hpp"
#include "picture/plot.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

/// The result of a search for the best machine.
struct Optimum {
    std::vector<std::string> measures; ///< the one or two measures that were minimised, with their units
    Trial start;                       ///< the unchanged netlist, with the settings that all machines share
    std::vector<SearchCourse>
        courses; ///< the genetic course comes first and has feasible machines; the other courses may have none

    /// Returns the machines of all courses, each once, in the order of the courses.
    SearchCourse together() const;
};

/// Returns the indices, in the course, of the machines to be shown: the best few machines for one cost, the front for
/// two costs. Of machines with equal costs, only one is shown.
std::vector<std::size_t> best_of(const SearchCourse&);

/// Returns the minimised measures, followed by the study's other measures. REQUIRES: the study has a search.
std::vector<std::string> shown_measures(const Study&);

/// Returns the settings and measures of the best machines, the best first.
StudySummary summary_of_best(StudyResults&, const Study&, const MachineSpace&, const SearchCourse&);

/// Prints the unchanged netlist, then what each method found and the number of machines tried until then.
std::string print_comparison(const Optimum&);

/// Explains why two runs take different times, by the activities on their critical paths.
std::string print_paths(const std::vector<PathPart>& start, const std::vector<PathPart>& best);

/// Returns the plot: for one measure, the best value over the number of machines simulated; for two, all machines and
/// the front.
Plot optimum_plot(const Optimum&, const std::string& title);

/// Returns the `placedpar run` command that repeats the run.
std::string command_of(const Study&, const Overrides& settings);

/// Lists the reasons why all machines are infeasible, the most frequent reason first.
std::string print_why_none(const SearchCourse&);

} // namespace placedpar
