#pragma once

#include "picture/plot.hpp"
#include "report/search_log.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace placedpar {

/// Describes a quantity of a search, such as the best fitness, over the generations of each run.
struct ConvergenceCurve {
    std::string name;                      ///< name in the legend
    std::vector<std::vector<double>> runs; ///< values of each run from generation `first` on
    int colour;                            ///< one of a plot's eight colours
    Stroke stroke = Stroke::line;          ///< points have no quartiles
    std::uint64_t first = 1;
};

/// Draws the median over the runs for each curve and each generation that all runs made. With two or more runs, the
/// quartiles surround the median. Values that are not finite are left out. Long runs are thinned to a few hundred
/// points; the last generation is always kept. Throws std::invalid_argument for a curve without runs or a run without
/// generations.
Panel convergence_panel(std::string title, std::string label, std::span<const ConvergenceCurve>);

/// Draws the best and the mean fitness of all searches together or, if the problem has an objective, the best objective
/// so far and the mean objective. The diversity of the searches is drawn below. Curves show medians and quartiles over
/// the seeds. Searches that cannot be compared (GenerationLog::compares()) are drawn separately. The axis of a positive
/// objective that is minimised is logarithmic. The axis of a fitness leaves out values of the first generations that
/// are far lower than the others. Throws UserError if some run made no generation, or no generation with a finite
/// objective. REQUIRES: at least one log; all logs are of one network.
Plot convergence_plot(std::string title, std::span<const SeededLog>);

} // namespace placedpar
