#pragma once

#include "explore/study/results.hpp"
#include "explore/study/study.hpp"
#include "report/comparison.hpp"

#include <vector>

namespace placedpar {

/// Returns the tables of a study. A figure is the mean over the study's seeds. A figure is NaN if one of its runs did
/// not complete or did not measure it, or if the figure cannot be computed; the table's notes say why. REQUIRES: the
/// study's runs have been made.
std::vector<Comparison> comparisons_of(const Study&, StudyResults&);

} // namespace placedpar
