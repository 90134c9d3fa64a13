#pragma once

#include "explore/study/summary.hpp"
#include "picture/plot.hpp"

#include <string>

namespace placedpar {

/// For people: a line a combination, with means and the intervals around them.
std::string print_summary(const StudySummary&);
/// The same as comma-separated values.
std::string summary_csv(const StudySummary&);

/// The measures over the axis that has most numbers, or over the one that is named, a panel a measure, a curve for
/// each combination of the other axes; 95 % intervals as bars. Throws UserError where there is nothing to draw, and for
/// more curves than can be told apart.
Plot summary_plot(const StudySummary&, const std::string& over = "");

/// A page of HTML that needs no other file: the plot, where it can be drawn, the table, and what was run.
std::string summary_page(const StudySummary&, const std::string& over = "");

} // namespace placedpar
