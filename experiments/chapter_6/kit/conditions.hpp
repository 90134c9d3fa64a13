#pragma once

#include "experiments/chapter_6/kit/plant_runs.hpp"
#include "experiments/kit/seed_runs.hpp"
#include "report/comparison.hpp"
#include "text/interval.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

/// The expected results of a condition (the settings of a search that are compared), measured with other seeds. These
/// are the percentages of runs that converge, and that follow the plant's pole.
struct Expected {
    std::optional<double> converged, followed;
};

struct Tally {
    std::string name;
    std::size_t runs = 0, converged = 0, followed = 0;
    std::vector<double> converged_at = {}; ///< PlantOutcome::converged_at of each run

    double converged_percent() const;
    double followed_percent() const;
};

/// Calls `run` with each seed of the replay, and counts the outcomes. `name` must be unique within the experiment.
Tally tally_runs(const ReplayContext&, const std::string& name, const std::function<PlantOutcome(std::uint64_t)>& run);
Tally tally_search(const ReplayContext&, const std::string& name, const PlantSearch&);

/// Adds a row with the shares of runs that converged and that followed the pole, and the median generation of
/// convergence, each with its 95 % interval. A share with an expected value may deviate by share_tolerance(), which is
/// four standard deviations of the difference of two samples.
void add_tally(Comparison&, const Tally&, const Expected& = {});
/// Adds a row with two 95 % intervals, in percentage points. The first is the interval of the gain over `control` in
/// the share of converged runs, the second in the share of runs that followed the pole.
void add_gain(Comparison&, const Tally& control, const Tally&);

struct Condition {
    std::string name;
    PlantSearch search;
    Expected expected = {};
};

/// A group of conditions. `shares` has the rows of add_tally(), and `gains` the rows of add_gain() over the first
/// condition.
struct ConditionGroup {
    Comparison shares, gains;
    std::vector<Tally> tallies;
};
/// Runs the conditions. `control` is the name of the first condition in the title of `gains`. `name` must be unique
/// within the experiment. REQUIRES: at least one condition.
ConditionGroup compare_conditions(const ReplayContext&, const std::string& name, const std::string& control,
                                  const std::vector<Condition>&);

/// Returns the figure in a row and a column. REQUIRES: the table has this cell.
double figure_in(const Comparison& table, const std::string& row, const std::string& column);

} // namespace placedpar
