#pragma once

#include "picture/plot.hpp"

#include <cstddef>
#include <string>

namespace placedpar {

/// How the parts of a panel look, in gnuplot's words. What has a colour of its own has a symbol and dashes of its own,
/// too, so that it can be told apart in grey.

/// As gnuplot writes it: "#0072B2". Beyond the eight they begin anew.
const char* colour_named(int number);
/// Of the panel's series at `place`: the one that it asks for, or that of its place.
const char* colour_of(const Panel& panel, std::size_t place);

std::string style_of(const Panel& panel, std::size_t place);
/// Marks of a panel differ in their dashes.
std::string style_of(const Mark& mark, std::size_t place);
std::string style_of(const Band& band);

} // namespace placedpar
