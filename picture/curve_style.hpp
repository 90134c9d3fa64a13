#pragma once

#include "picture/plot.hpp"

#include <cstddef>
#include <string>

namespace placedpar {

/// These functions return the look of a panel's parts as gnuplot's commands state it. Each colour has its own symbol
/// and dashes, too, so that curves differ in grey.

/// Returns the colour as gnuplot writes it: "#0072B2". The eight colours repeat.
const char* colour_named(int number);
/// Returns the colour of series number `place` of the panel: the colour that the series states, or else the default
/// colour of that number.
const char* colour_of(const Panel& panel, std::size_t place);

std::string style_of(const Panel& panel, std::size_t place);
/// Returns the style of the mark at `place`. Neighbouring marks of a panel differ in their dashes.
std::string style_of(const GuideLine& mark, std::size_t place);
std::string style_of(const Band& band);

} // namespace placedpar
