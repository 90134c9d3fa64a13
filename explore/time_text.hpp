#pragma once

#include "runtime/time.hpp"

#include <string>

namespace placedpar {

/// Reads a simulated time or duration: "100ms", "2.5us", "1e3us", "0". The units are s, ms, us, ns and ps; the
/// resolution is 1 ps. Throws UserError if the text is not such a time.
Time parse_time(const std::string& text);

} // namespace placedpar
