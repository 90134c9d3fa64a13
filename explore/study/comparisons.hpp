#pragma once

#include "explore/study/results.hpp"
#include "explore/study/study.hpp"
#include "report/comparison.hpp"

#include <vector>

namespace placedpar {

/// The tables of a study. A figure is the mean over the study's seeds; it is not a number where one of its runs did not
/// come to its end or did not measure it, or where it cannot be computed, and the table's notes say why. REQUIRES: its
/// runs have been made.
std::vector<Comparison> comparisons_of(const Study&, StudyResults&);

} // namespace placedpar
