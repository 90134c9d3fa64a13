#pragma once

#include <string_view>

namespace placedpar {

/// Tells whether a channel's end is an input or an output of the process or device at this end.
enum class Direction { input, output };

/// Returns "input" or "output".
constexpr const char* word(Direction direction) { return direction == Direction::input ? "input" : "output"; }

/// Returns the direction that the word names. REQUIRES: the word is "input" or "output".
constexpr Direction direction_named(std::string_view word) {
    return word == "input" ? Direction::input : Direction::output;
}

} // namespace placedpar
