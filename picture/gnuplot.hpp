#pragma once

#include <string>

namespace placedpar {

/// What gnuplot writes to its output for this script. Throws UserError when it is not installed, std::runtime_error
/// with gnuplot's words when it refuses the script. The user's own settings of gnuplot are not read.
std::string run_gnuplot(const std::string& script);

/// Throws UserError when gnuplot is not on the path, so that a long run is not lost.
void require_gnuplot();

} // namespace placedpar
