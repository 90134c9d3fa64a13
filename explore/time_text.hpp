#pragma once

#include "runtime/time.hpp"

#include <string>

namespace placedpar {

/// A moment or a span of virtual time: "100ms", "2.5us", "1e3us", "0"; in s, ms, us, ns or ps, down to a picosecond.
/// Throws UserError when the text is no such time.
Time parse_time(const std::string& text);

} // namespace placedpar
