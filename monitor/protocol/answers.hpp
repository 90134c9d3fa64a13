#pragma once

#include "identification/on_line/diagnosis.hpp"
#include "identification/transient_search.hpp"
#include "monitor/protocol/bad_message.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace placedpar::monitor {

/// The rates at which the monitor, a service that diagnoses excavators, works.
struct LoadRates {
    double over_s = 0; ///< length of the interval over which the rates were measured
    double samples_per_s = 0;
    double generations_per_s = 0;
    double work_of_core = 0; ///< time spent on messages, as a share of one core's time
    /// The processor time of the service's thread, including network traffic, as a share of one core's time.
    double cpu_of_core = 0;
};
struct Load {
    LoadRates rates;
    std::size_t clients = 0;
    std::size_t machines = 0;
    std::size_t queued_bytes = 0; ///< bytes waiting to be sent, all clients together
    std::uint64_t samples = 0;    ///< `samples`, `generations`, `work_s` and `cpu_s` are totals since the start of the
                                  ///< service
    std::uint64_t generations = 0;
    double work_s = 0; ///< time spent on messages
    double cpu_s = 0;  ///< processor time of the service's thread
    double uptime_s = 0;
    double longest_turn_s = 0; ///< longest turn of the event loop, during which no client was served
};

/// The compliances that simulated transputers found for one movement of a machine. The option --on names their netlist,
/// the description of the network.
struct NetlistAnswer {
    std::string machine;
    hydraulics::LinkSet set;
    double from_s = 0, to_s = 0; ///< times of the movement's first and last reading
    hydraulics::Circuit circuit;
    std::string wrong;                  ///< why there is no answer; "" if `found` is the answer
    identification::AnswerInTime found; ///< the answer, if `wrong` is ""
};

/// Each function returns one answer of the monitor: a JSON object on one line, with its newline. docs/guides/monitor.md
/// describes the answers.

std::string welcome_line(const identification::Diagnosis& diagnosis, std::uint64_t seed);
std::string configured_line(const identification::Diagnosis& diagnosis);
std::string estimates_line(const identification::Diagnosis& diagnosis, const identification::SampleOutcome& outcome,
                           const identification::DiagnosisSettings& settings);
std::string alarm_line(const identification::Diagnosis& diagnosis, const identification::Alarm& alarm, bool raised);
/// Returns everything that is known about a machine: the estimates of all sets of links, baselines (compliances of the
/// healthy links), cross-checks and alarms.
std::string status_line(const identification::Diagnosis& diagnosis, const identification::DiagnosisSettings& settings);
std::string netlist_line(const NetlistAnswer& answer);
/// Returns the field "text" of netlist_line().
std::string print_netlist_answer(const NetlistAnswer& answer);
std::string load_line(const Load& load);
/// States whether a restart would restore everything. If `kept` is false, `text` gives the reason.
std::string kept_line(bool kept, std::string_view text);
/// `line` is the number of the refused line in its connection, counted from 1.
std::string error_line(std::size_t line, const BadMessage& error);
/// Returns {"type":TYPE}, with a field "text" unless `text` is empty.
std::string plain_line(std::string_view type, std::string_view text = "");

} // namespace placedpar::monitor
