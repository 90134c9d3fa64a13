#pragma once

#include "runtime/time.hpp"

#include <string>

namespace placedpar {

/// Reads a point or a span of virtual time: "100ms", "2.5us", "1e3us", "0"; in s, ms, us, ns or ps, with a resolution
/// of 1 ps. Throws UserError if the text is not such a time.
Time parse_time(const std::string& text);

} // namespace placedpar
