#pragma once

#include "explore/study/results.hpp"
#include "explore/study/study.hpp"
#include "report/comparison.hpp"

#include <vector>

namespace placedpar {

/// The tables of a study whose runs have been made. A figure is the mean over the study's seeds. Throws UserError where
/// a run is missing or did not come to its end, or a figure cannot be computed.
std::vector<Comparison> comparisons_of(const Study&, StudyResults&);

} // namespace placedpar
