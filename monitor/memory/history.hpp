#pragma once

#include "monitor/memory/entries.hpp"
#include "store/database.hpp"

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

    /// Reads every row; throws std::runtime_error naming one whose checksum is wrong.
    void check();

    void keep(const KeptEstimate& estimate);
    void keep(const KeptAlarm& alarm);
    /// The newest row of the same machine, kind and links gets these times.
    void change(const KeptAlarm& alarm);
    void reconcile(const OpenAlarms& open);
    void forget(const std::string& machine);

    /// Of one machine, the newest first.
    std::vector<KeptEstimate> estimates(const std::string& machine, std::uint64_t most);
    /// Likewise; of all machines with "".
    std::vector<KeptAlarm> alarms(const std::string& machine, std::uint64_t most);
    /// Those not cleared, of all machines, by machine and age.
    std::vector<KeptAlarm> open_alarms();
    /// Those, and those that have been on the shelf.
    std::vector<KeptAlarm> noted_alarms();

private:
    std::uint64_t most_;
    store::Statement next_estimate_, insert_estimate_, trim_estimates_, select_estimates_, all_estimates_;
    store::Statement next_alarm_, insert_alarm_, trim_alarms_, find_alarm_, update_alarm_, select_alarms_,
        newest_alarms_, all_alarms_, noted_alarms_;
    store::Statement forget_estimates_, forget_alarms_;
};

} // namespace placedpar::monitor
