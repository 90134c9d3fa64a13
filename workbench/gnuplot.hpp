#pragma once

#include <string>

namespace placedpar {

/// What gnuplot writes to its output for this script. Throws std::runtime_error when it is not installed or refuses
/// the script, with its words. The user's own settings of gnuplot are not read.
std::string run_gnuplot(const std::string& script);

/// Throws std::runtime_error when gnuplot is not on the path, so that a long run is not lost.
void require_gnuplot();

} // namespace placedpar
