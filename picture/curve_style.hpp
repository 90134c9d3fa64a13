#pragma once

#include "picture/plot.hpp"

#include <cstddef>
#include <string>

namespace placedpar {

/// These functions return the colours and styles of a panel's parts in the language of gnuplot, which draws the plot.
/// Each colour has its own symbol and dashes, so that curves can also be distinguished without colour.

/// Returns the colour as gnuplot writes it: "#0072B2". The eight colours repeat.
const char* colour_named(int number);
/// Returns the colour of the panel's series with index `place`: the colour that the series states, or else the default
/// colour for this index.
const char* colour_of(const Panel& panel, std::size_t place);

std::string style_of(const Panel& panel, std::size_t place);
/// Returns the style of a mark with index `place`. Neighbouring marks of a panel have different dashes.
std::string style_of(const GuideLine& mark, std::size_t place);
std::string style_of(const Band& band);

} // namespace placedpar
