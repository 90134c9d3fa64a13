#pragma once

#include "explore/time_text.hpp"
#include "runtime/time.hpp"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace placedpar {

/// An option that takes a moment or a span of virtual time: "100ms", "2.5us", "1e3us", "0"; in s, ms, us, ns or ps,
/// down to a picosecond.
CLI::Option* add_time(CLI::App&, const std::string& option, Time& time, const std::string& about);
/// The same where nothing may be said.
CLI::Option* add_time(CLI::App&, const std::string& option, std::optional<Time>& time, const std::string& about);

} // namespace placedpar
