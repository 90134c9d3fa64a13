#pragma once

#include "explore/study/results.hpp"
#include "explore/study/study.hpp"
#include "report/comparison.hpp"

#include <vector>

namespace placedpar {

/// Returns the tables of a study, which compare figures of its runs with known figures. A figure is the mean over the
/// study's seeds. A figure is NaN if a run did not complete, if a run lacks the measure, or if the expression cannot be
/// computed; the table's notes then say why. REQUIRES: the study's runs have been made.
std::vector<Comparison> comparisons_of(const Study&, StudyResults&);

} // namespace placedpar
