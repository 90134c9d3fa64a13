#pragma once

#include "identification/on_line/diagnosis.hpp"
#include "monitor/memory/entries.hpp"
#include "monitor/protocol/message.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace placedpar::monitor {

/// Keeps the active alarms of all machines (excavators under diagnosis) and the time at which each alarm was raised.
/// Functions that change an alarm return the entry that the caller adds to the history in the state file. Times are in
/// seconds since 1970.
class AlarmBoard {
public:
    /// Restores the active and the shelved alarms from the history after a restart. A shelved alarm is one of which the
    /// operator does not want to hear for some time.
    void restore(std::vector<KeptAlarm> noted);

    Entry raise(const identification::Diagnosis& diagnosis, const identification::Alarm& alarm, double at);
    Entry clear(const std::string& machine, const identification::Alarm& alarm, double at);
    void forget(const std::string& machine);
    /// Records that an operator has seen the alarm at time `at`. Returns nullopt if the alarm is not active, as
    /// shelve() does.
    std::optional<Entry> acknowledge(const AlarmName& name, double at);
    std::optional<Entry> shelve(const AlarmName& name, double until, double at);
    /// Returns whether the alarm is shelved at time `at`.
    bool shelved(const std::string& machine, const identification::Alarm& alarm, double at) const;

    /// Returns the active alarms of a machine in the order in which they were raised.
    const std::vector<KeptAlarm>& of(const std::string& machine) const;
    std::vector<KeptAlarm> all() const;

private:
    KeptAlarm* find(const AlarmName& name);
    std::optional<double> shelved_until(const KeptAlarm& alarm, double at) const;

    std::map<std::string, std::vector<KeptAlarm>> open_;
    /// Copies of the shelved alarms. An alarm stays shelved when it is cleared and raised again, so its copy stays
    /// here.
    std::map<std::string, std::vector<KeptAlarm>> shelved_;
};

} // namespace placedpar::monitor
