#pragma once

#include "gaprocs/generation_log.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace placedpar {

/// Where a run stands, in one line: "generation 80: best 3996.92, mean 3412.1, diversity 0.0312"; of all searches, or
/// the first where they search for different things. "" before the first generation.
std::string state_of(const GenerationLog&);

/// Best and mean fitness over the generations so far, drawn with letters, and diversity below: lines of at most
/// `columns` columns, of which `rows` are the curve. The tenth of all that is worst, as the first generations may be by
/// far, is drawn on the last row of that end. Always as many lines. REQUIRES: columns >= 24, rows >= 2.
std::vector<std::string> live_curve(const GenerationLog&, std::size_t columns, std::size_t rows);

} // namespace placedpar
