#pragma once

#include "identification/on_line/diagnosis.hpp"
#include "monitor/protocol/bad_message.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace placedpar::monitor {

/// What the service has to do, and what that takes.
struct LoadRates {
    double over_s = 0; ///< how long these were measured
    double samples_per_s = 0;
    double generations_per_s = 0;
    double work_of_core = 0; ///< time spent on messages, as a fraction of one core
    double cpu_of_core = 0;  ///< processor time of the service's thread, the network's share included
};
struct Load {
    LoadRates rates;
    std::size_t clients = 0;
    std::size_t machines = 0;
    std::size_t queued_bytes = 0; ///< waiting to be sent, to all clients
    std::uint64_t samples = 0;    ///< this and the rest: since the service started
    std::uint64_t generations = 0;
    double work_s = 0; ///< spent on messages
    double cpu_s = 0;  ///< processor time of the service's thread
    double uptime_s = 0;
    double longest_turn_s = 0; ///< of the event loop: so long nobody was heard
};

/// What the monitor says, each one JSON object in one line with its newline; docs/guides/monitor.md is the description.

std::string welcome_line(const identification::Diagnosis& diagnosis, std::uint64_t seed);
std::string configured_line(const identification::Diagnosis& diagnosis);
std::string estimates_line(const identification::Diagnosis& diagnosis, const identification::SampleOutcome& outcome,
                           const identification::DiagnosisSettings& settings);
std::string alarm_line(const identification::Diagnosis& diagnosis, const identification::Alarm& alarm, bool raised);
/// All that is known: all sets ever used, baselines, cross-checks, alarms.
std::string status_line(const identification::Diagnosis& diagnosis, const identification::DiagnosisSettings& settings);
std::string load_line(const Load& load);
/// Whether what is known would survive a restart; if not, `text` says why.
std::string kept_line(bool kept, std::string_view text);
/// `line` counts the lines of the connection from 1.
std::string error_line(std::size_t line, const BadMessage& error);
/// {"type":TYPE} and, where there is one, a text.
std::string plain_line(std::string_view type, std::string_view text = "");

} // namespace placedpar::monitor
