#pragma once

#include "explore/study/summary.hpp"
#include "picture/plot.hpp"

#include <string>

namespace placedpar {

/// Returns the summary of a study's runs as a table: a line for each combination of settings, with the means of the
/// measures and their confidence intervals.
std::string print_summary(const StudySummary&);
std::string summary_csv(const StudySummary&);
/// Returns a table in long form, with a row for each run: its settings, its seed, how it ended, and its measures.
std::string runs_csv(const StudySummary&);
/// Returns a table of rank tests. For each setting that varies, and each combination of the other settings, a test says
/// whether the setting affects a measure. Returns "" if no combination was run with several seeds, or if figures do not
/// depend on the seed.
std::string print_rank_tests(const StudySummary&);

/// Plots the measures against the setting `over`. If `over` is "", chooses the setting with the most values among the
/// settings that have only numbers. There is a panel for each measure, and a curve with 95 % intervals for each
/// combination of the other settings. Throws UserError if there is nothing to draw, or if there are more curves than
/// can be told apart.
Plot summary_plot(const StudySummary&, const std::string& over = "");

/// Returns a self-contained page of HTML with the plot if it can be drawn, the table, and a description of the runs.
std::string summary_page(const StudySummary&, const std::string& over = "");

} // namespace placedpar
