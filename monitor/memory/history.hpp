#pragma once

#include "monitor/memory/entries.hpp"
#include "monitor/memory/history_table.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace placedpar::monitor {

/// The tables of what has been found of the machines, and of their alarms. Of each machine the newest `most` rows of
/// either are kept. All functions throw DatabaseError; those that change belong into a transaction.
class History {
public:
    static const char* const schema;

    /// REQUIRES: the database outlives it and has the tables.
    History(store::Database& database, std::uint64_t most);

    /// Reads every row, and gives the sum of their checksums. Throws std::runtime_error naming one whose is wrong.
    std::uint64_t check() { return estimates_.check() + alarms_.check(); }

    void keep(const KeptEstimate& estimate) { estimates_.keep(estimate); }
    void keep(const KeptAlarm& alarm) { alarms_.keep(alarm); }
    /// The newest row of the same machine, kind and links gets these times.
    void change(const KeptAlarm& alarm);
    void reconcile(const OpenAlarms& open);
    void forget(const std::string& machine);

    /// Of one machine, the newest first.
    std::vector<KeptEstimate> estimates(const std::string& machine, std::uint64_t most) {
        return estimates_.newest(machine, most);
    }
    /// Likewise; of all machines with "".
    std::vector<KeptAlarm> alarms(const std::string& machine, std::uint64_t most);
    /// Those not cleared, of all machines, by machine and age.
    std::vector<KeptAlarm> open_alarms();
    /// Those, and those that have been on the shelf.
    std::vector<KeptAlarm> noted_alarms() { return alarms_.rows(noted_alarms_.bind()); }

private:
    HistoryTable<KeptEstimate> estimates_;
    HistoryTable<KeptAlarm> alarms_;
    store::Statement find_alarm_, newest_alarms_, noted_alarms_;
};

} // namespace placedpar::monitor
