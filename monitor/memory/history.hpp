#pragma once

#include "monitor/memory/entries.hpp"
#include "monitor/memory/history_table.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace placedpar::monitor {

/// The history in the state file: the tables of settled estimates and of alarms, which the web page shows. Each table
/// keeps the newest `most` rows of each machine. All functions throw DatabaseError. Functions that change a table must
/// run inside a transaction.
class History {
public:
    static const char* const schema;

    /// REQUIRES: the database outlives this object and has the tables.
    History(store::Database& database, std::uint64_t most);

    /// Reads every row and returns the sum of their checksums. Throws std::runtime_error, naming the first row with a
    /// wrong checksum.
    std::uint64_t check() { return estimates_.check() + alarms_.check(); }

    void keep(const KeptEstimate& estimate) { estimates_.keep(estimate); }
    void keep(const KeptAlarm& alarm) { alarms_.keep(alarm); }
    /// Replaces the times of an alarm, in the newest row with the same machine, kind and links.
    void change(const KeptAlarm& alarm);
    /// Marks every alarm as cleared that is open in the table but not in `open`, after some changes were lost.
    void reconcile(const OpenAlarms& open);
    void forget(const std::string& machine);

    /// Returns at most `most` estimates of one machine, newest first.
    std::vector<KeptEstimate> estimates(const std::string& machine, std::uint64_t most) {
        return estimates_.newest(machine, most);
    }
    /// Returns at most `most` alarms, newest first, of one machine, or of all machines if `machine` is "".
    std::vector<KeptAlarm> alarms(const std::string& machine, std::uint64_t most);
    /// Returns the alarms that are not cleared, of all machines, ordered by machine and age.
    std::vector<KeptAlarm> open_alarms();
    /// Returns the alarms that are not cleared, and the alarms that an operator has ever shelved, that is, suppressed
    /// for some time.
    std::vector<KeptAlarm> noted_alarms() { return alarms_.rows(noted_alarms_.bind()); }

private:
    HistoryTable<KeptEstimate> estimates_;
    HistoryTable<KeptAlarm> alarms_;
    store::Statement find_alarm_, newest_alarms_, noted_alarms_;
};

} // namespace placedpar::monitor
