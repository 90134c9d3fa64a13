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

/// What is expected of a condition, in percent of the runs: of other seeds of this program.
struct Expected {
    std::optional<double> converged, followed;
};

/// What a condition's runs came to.
struct Tally {
    std::string name;
    std::size_t runs = 0, converged = 0, followed = 0;
    std::vector<double> converged_at = {}; ///< generation, for each run

    double converged_percent() const;
    double followed_percent() const;
};

/// A run for each seed. The name tells the condition from all others of the experiment.
Tally tally_runs(const ReplayContext&, const std::string& name, const std::function<PlantOutcome(std::uint64_t)>& run);
Tally tally_search(const ReplayContext&, const std::string& name, const PlantSearch&);

/// A row: both shares with their 95 % intervals, and the median generation of convergence with its own. Shares that are
/// expected are judged at four deviations of two samples (share_tolerance).
void add_tally(Comparison&, const Tally&, const Expected& = {});
/// A row: the 95 % interval of how many percent points more runs converged and followed than with the control.
void add_gain(Comparison&, const Tally& control, const Tally&);

} // namespace placedpar
