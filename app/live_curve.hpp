#pragma once

#include "gaprocs/generation_log.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace placedpar {

/// Returns the state of a run in one line: "generation 80: best 3996.92, mean 3412.1, diversity 0.0312". The line
/// covers all searches, or only the first search if their objectives differ. Returns "" before the first generation.
std::string state_of(const GenerationLog&);

/// Draws best and mean fitness over the generations so far with text characters, and diversity below. Lines have at
/// most `columns` characters; the curve takes `rows` lines. The worst tenth of the values, often from the first
/// generations, is clipped to the edge of the curve. The number of lines is constant. REQUIRES: columns >= 24, rows >=
/// 2.
std::vector<std::string> live_curve(const GenerationLog&, std::size_t columns, std::size_t rows);

} // namespace placedpar
