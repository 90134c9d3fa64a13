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

struct Optimum {
    std::vector<std::string> measures; ///< the one or two measures that were minimised, with their units
    Trial start; ///< result of the unchanged netlist, with the settings that are equal in all machines
    /// One for each method of search. The genetic algorithm comes first and has feasible machines; the other courses
    /// may have none.
    std::vector<SearchCourse> courses;

    /// Returns the machines of all courses, each once, in the order of the courses.
    SearchCourse together() const;
};

/// Returns which machines of the course to show, as indices: the best few machines for one cost, the Pareto front for
/// two costs. If several machines have equal costs, only one is shown.
std::vector<std::size_t> best_of(const SearchCourse&);

/// Returns the minimised measures, followed by the study's other measures. REQUIRES: Study::search has a value.
std::vector<std::string> shown_measures(const Study&);

/// Returns the settings and measures of the best machines, the best first.
StudySummary summary_of_best(StudyResults&, const Study&, const MachineSpace&, const SearchCourse&);

/// Prints a row for each method of search. With one cost, the rows have the best cost and the number of machines tried
/// until this cost was found. A row above has the cost of the unchanged netlist. With two costs, the rows have the
/// number of points on the method's front, and how many of these points are on the joint front of all methods.
std::string print_comparison(const Optimum&);

/// Prints how long each activity takes on the critical paths of two runs, the greatest difference first.
std::string print_paths(const std::vector<PathPart>& start, const std::vector<PathPart>& best);

/// Returns the plot of the search. With one minimised measure, the plot shows the best value so far against the number
/// of machines simulated. With two measures, the plot shows all machines and the front.
Plot optimum_plot(const Optimum&, const std::string& title);

/// Returns the `placedpar run` command for a run with these settings and the study's first seed.
std::string command_of(const Study&, const Overrides& settings);

/// Prints the most frequent reasons why machines are infeasible. REQUIRES: all machines of the course are infeasible.
std::string print_why_none(const SearchCourse&);

} // namespace placedpar
