#pragma once

namespace placedpar {

/// Which way messages pass through a channel's end, seen from what the end belongs to.
enum class Direction { input, output };

/// "input" or "output".
constexpr const char* word(Direction direction) { return direction == Direction::input ? "input" : "output"; }

} // namespace placedpar
