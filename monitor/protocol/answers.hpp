#pragma once

#include "identification/on_line/machine.hpp"
#include "monitor/protocol/load_meter.hpp"

#include <cstddef>
#include <string>

namespace placedpar::monitor {

/// What the monitor says, each one JSON object in one line with its newline; docs/monitor.md is the description.

std::string welcome_line(const Machine& machine, std::uint64_t seed);
std::string configured_line(const Machine& machine);
std::string estimates_line(const Machine& machine, const SampleOutcome& outcome, const DiagnosisSettings& settings);
std::string alarm_line(const Machine& machine, const Alarm& alarm, bool raised);
/// Everything: all sets ever used, baselines, cross-checks, alarms.
std::string status_line(const Machine& machine, const DiagnosisSettings& settings);
std::string load_line(const LoadMeter& meter, std::size_t clients, std::size_t machines, std::size_t queued_bytes);
/// Whether a restart would know what is known; if not, `text` says why.
std::string kept_line(bool kept, std::string_view text);
/// `line` counts the lines of the connection from 1.
std::string error_line(std::size_t line, const BadMessage& error);
/// {"type":TYPE} and, where there is one, a text.
std::string plain_line(std::string_view type, std::string_view text = "");

} // namespace placedpar::monitor
