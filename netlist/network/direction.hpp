#pragma once

#include <string_view>

namespace placedpar {

/// Which way messages pass through a channel's end, seen from what the end belongs to.
enum class Direction { input, output };

/// "input" or "output".
constexpr const char* word(Direction direction) { return direction == Direction::input ? "input" : "output"; }

/// REQUIRES: one of these words.
constexpr Direction direction_named(std::string_view word) {
    return word == "input" ? Direction::input : Direction::output;
}

} // namespace placedpar
