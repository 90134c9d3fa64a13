#pragma once

#include "picture/plot.hpp"
#include "report/search_log.hpp"

#include <span>
#include <string>
#include <vector>

namespace placedpar {

/// A quantity over the generations, run by run.
struct ConvergenceCurve {
    std::string name;                      ///< in the legend
    std::vector<std::vector<double>> runs; ///< each from generation 1 on
    int colour;                            ///< which of a plot's eight
    Stroke stroke = Stroke::line;          ///< points have no quartiles
};

/// Over the generations that all runs made, for each curve the median of the runs; around it, where there are two runs
/// at least, their quartiles. What is not finite is left out. Long runs are thinned out to some hundred points, of
/// which the last generation is one. Throws std::invalid_argument for a curve without runs or a run without
/// generations.
Panel convergence_panel(std::string title, std::string label, std::span<const ConvergenceCurve>);

/// Best and mean fitness of all searches together, or the best objective so far and the mean, and below them their
/// diversity, over the seeds of the logs; of each search where they search for different things. The axis of an
/// objective that is minimised and stays positive is logarithmic; that of a fitness leaves out what the first
/// generations may be lower by far. Throws UserError where a run made no generation, or none with a finite objective.
/// REQUIRES: logs of one network, one at least.
Plot convergence_plot(std::string title, std::span<const SeededLog>);

} // namespace placedpar
