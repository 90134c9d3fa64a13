#pragma once

#include "monitor/memory/entries.hpp"
#include "monitor/memory/history_table.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace placedpar::monitor {

/// Accesses the tables of estimates and alarms. Each table keeps the newest `most` rows of each machine. All functions
/// throw DatabaseError. Functions that change a table must run inside a transaction.
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
    /// Replaces the times in the newest row of the same machine, kind and links.
    void change(const KeptAlarm& alarm);
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
    /// Returns the alarms that are not cleared, and the alarms that were ever shelved.
    std::vector<KeptAlarm> noted_alarms() { return alarms_.rows(noted_alarms_.bind()); }

private:
    HistoryTable<KeptEstimate> estimates_;
    HistoryTable<KeptAlarm> alarms_;
    store::Statement find_alarm_, newest_alarms_, noted_alarms_;
};

} // namespace placedpar::monitor
