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

/// What came of a search for the best machine.
struct Optimum {
    std::vector<std::string> measures; ///< that were minimised: one or two, with their units
    Trial start;                       ///< the netlist as it is, with what all machines have in common
    std::vector<SearchCourse> courses; ///< the genetic one first, which has feasible machines; another may have none

    /// The machines of all courses, each once, those of the first before others.
    SearchCourse together() const;
};

/// The machines to be shown, by place in the course: of one cost the best few, of two the front; one of each cost.
std::vector<std::size_t> best_of(const SearchCourse&);

/// What is minimised, and then what else the study wants to know. REQUIRES: it has a search.
std::vector<std::string> shown_measures(const Study&);

/// Returns the settings and measures of the best machines, the best first.
StudySummary summary_of_best(StudyResults&, const Study&, const MachineSpace&, const SearchCourse&);

/// What each way found, and how much it tried for it: against the netlist as it is.
std::string print_comparison(const Optimum&);

/// Why one run takes another time than the other: by what their critical paths were spent with.
std::string print_paths(const std::vector<PathPart>& start, const std::vector<PathPart>& best);

/// One measure: the best found over the machines simulated. Two: all machines, and the front.
Plot optimum_plot(const Optimum&, const std::string& title);

/// Returns the `placedpar run` command that repeats the run.
std::string command_of(const Study&, const Overrides& settings);

/// Says what made all machines infeasible, the most frequent first.
std::string print_why_none(const SearchCourse&);

} // namespace placedpar
