#pragma once

#include "experiments/chapter_3/kit/boom_search.hpp"
#include "picture/plot.hpp"

#include <span>
#include <string>
#include <vector>

namespace placedpar {

/// Returns a curve of the values over the times, up to `until_s`. REQUIRES: a time for each value.
Series over_time(std::string name, std::span<const double> time_s, std::span<const double> values, double until_s,
                 Stroke stroke = Stroke::line);

/// Draws Figure 3.3: pressures, voltage, spool and angle as recorded.
Plot plot_of_record(std::string title, const BoomData& data, double until_s);

/// The data of Figure 3.5 or 3.6: a record of a motion, and the search for the compliance in this record.
struct WatchedIdentification {
    std::string title;
    const BoomData& data;
    BoomModel model;
    const BoomIdentified& identified;
    const std::vector<Generation>& generations;
};
Plot plot_of_identification(const WatchedIdentification&, double until_s);

} // namespace placedpar
