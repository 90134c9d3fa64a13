#pragma once

#include "identification/on_line/diagnosis.hpp"
#include "monitor/memory/entries.hpp"
#include "monitor/protocol/message.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace placedpar::monitor {

/// The alarms that hold, and since when. What changes is given as an entry for the history.
class AlarmBoard {
public:
    /// From the history: alarms that hold, and those that are on the shelf.
    void restore(std::vector<KeptAlarm> noted);

    Entry raise(const identification::Diagnosis& diagnosis, const identification::Alarm& alarm, double at);
    Entry clear(const std::string& machine, const identification::Alarm& alarm, double at);
    void forget(const std::string& machine);
    /// None when it does not hold.
    std::optional<Entry> acknowledge(const AlarmName& name, double at);
    std::optional<Entry> shelve(const AlarmName& name, double until, double at);
    /// Is it on the shelf now?
    bool shelved(const std::string& machine, const identification::Alarm& alarm, double at) const;

    /// Of one machine, in the order in which they were raised.
    const std::vector<KeptAlarm>& of(const std::string& machine) const;
    std::vector<KeptAlarm> all() const;

private:
    KeptAlarm* find(const AlarmName& name);
    std::optional<double> shelved_until(const KeptAlarm& alarm, double at) const;

    std::map<std::string, std::vector<KeptAlarm>> open_;
    std::map<std::string, std::vector<KeptAlarm>> shelved_; ///< that hold or not, as they were when they were put there
};

} // namespace placedpar::monitor
