#pragma once

#include <string>

namespace placedpar {

/// Runs gnuplot with this script and returns its output. Throws UserError if gnuplot is not installed, or with
/// gnuplot's message if gnuplot refuses the script. Gnuplot does not read the user's own settings.
std::string run_gnuplot(const std::string& script);

/// Throws UserError if gnuplot is not on the path. Call this function before a long run whose results are to be
/// plotted.
void require_gnuplot();

} // namespace placedpar
