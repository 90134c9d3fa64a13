#pragma once

#include "picture/plot.hpp"

#include <cstddef>
#include <string>

namespace placedpar {

/// Functions for the look of a panel's parts, in gnuplot's words. Each colour has its own symbol and dashes, too, so
/// that curves differ in grey.

/// Returns the colour as gnuplot writes it: "#0072B2". The eight colours repeat.
const char* colour_named(int number);
/// Returns the colour of the panel's series at `place`: its own colour, or else the colour of this place.
const char* colour_of(const Panel& panel, std::size_t place);

std::string style_of(const Panel& panel, std::size_t place);
/// Returns the style of the mark at `place`. Neighbouring marks of a panel differ in their dashes.
std::string style_of(const GuideLine& mark, std::size_t place);
std::string style_of(const Band& band);

} // namespace placedpar
