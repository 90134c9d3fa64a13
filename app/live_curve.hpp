#pragma once

#include "gaprocs/generation_log.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace placedpar {

/// Returns the state of a running search in one line: "generation 80: best 3996.92, mean 3412.1, diversity 0.0312". If
/// the run has several searches, the line covers all of them, or only the first if their objectives differ. Returns ""
/// before the first generation.
std::string state_of(const GenerationLog&);

/// Draws best and mean fitness over the generations so far with text characters, and diversity below. Lines have at
/// most `columns` characters. The curve takes `rows` lines. The worst tenth of the values, often from the first
/// generations, is drawn at the edge of the curve, so that the other values fill it. The number of lines returned is
/// constant. REQUIRES: columns >= 24, rows >= 2.
std::vector<std::string> live_curve(const GenerationLog&, std::size_t columns, std::size_t rows);

} // namespace placedpar
