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

/// The expected results of a condition, in percent of the runs, from other seeds of this program.
struct Expected {
    std::optional<double> converged, followed;
};

/// The results of a condition's runs.
struct Tally {
    std::string name;
    std::size_t runs = 0, converged = 0, followed = 0;
    std::vector<double> converged_at = {}; ///< generation of each run

    double converged_percent() const;
    double followed_percent() const;
};

/// Makes a run for each seed. `name` must be unique within the experiment.
Tally tally_runs(const ReplayContext&, const std::string& name, const std::function<PlantOutcome(std::uint64_t)>& run);
Tally tally_search(const ReplayContext&, const std::string& name, const PlantSearch&);

/// Adds a row with both shares and their 95 % intervals, and the median generation of convergence with its 95 %
/// interval. Shares with an expected value are judged at four standard deviations of two samples (share_tolerance).
void add_tally(Comparison&, const Tally&, const Expected& = {});
/// Adds a row with the 95 % interval of the increase, in percentage points, of runs that converged and followed
/// compared with the control.
void add_gain(Comparison&, const Tally& control, const Tally&);

} // namespace placedpar
