#include "monitor/memory/history.hpp"

#include <algorithm>

namespace placedpar::monitor {

const char* const History::schema =
    "CREATE TABLE estimates(machine TEXT NOT NULL, number INTEGER NOT NULL, at REAL NOT NULL, time_s REAL NOT NULL, "
    "population_set TEXT NOT NULL, link TEXT NOT NULL, compliance REAL NOT NULL, error REAL, "
    "checksum INTEGER NOT NULL, PRIMARY KEY(machine, number)) WITHOUT ROWID;"
    "CREATE TABLE alarms(machine TEXT NOT NULL, number INTEGER NOT NULL, kind TEXT NOT NULL, links TEXT NOT NULL, "
    "text TEXT NOT NULL, raised_at REAL NOT NULL, raised_time_s REAL, cleared_at REAL, acknowledged_at REAL, "
    "shelved_until REAL, "
    "checksum INTEGER NOT NULL, PRIMARY KEY(machine, number)) WITHOUT ROWID;"
    "CREATE INDEX alarms_by_time ON alarms(raised_at);";

History::History(store::Database& d, std::uint64_t most)
    : estimates_(d, "estimates", most), alarms_(d, "alarms", most),
      find_alarm_(d, "SELECT * FROM alarms WHERE machine = ?1 AND kind = ?2 AND links = ?3 "
                     "ORDER BY number DESC LIMIT 1"),
      newest_alarms_(d, "SELECT * FROM alarms ORDER BY raised_at DESC, machine, number DESC LIMIT ?1"),
      noted_alarms_(d, "SELECT * FROM alarms WHERE cleared_at IS NULL OR shelved_until IS NOT NULL "
                       "ORDER BY machine, number") {}

void History::change(const KeptAlarm& a) {
    if (!find_alarm_.bind(a.machine, a.kind, a.links).step())
        return; // the row is so old that it has been deleted
    const std::uint64_t number = alarms_.number(find_alarm_);
    KeptAlarm changed = alarms_.row(find_alarm_);
    changed.cleared_at = a.cleared_at;
    changed.acknowledged_at = a.acknowledged_at;
    changed.shelved_until = a.shelved_until;
    find_alarm_.reset();
    alarms_.replace(number, changed);
}

void History::reconcile(const OpenAlarms& open) {
    std::vector<KeptAlarm> known = open_alarms();
    auto among = [](const std::vector<KeptAlarm>& alarms, const KeptAlarm& alarm) {
        return std::ranges::any_of(alarms, [&](const KeptAlarm& each) { return each.same_as(alarm); });
    };
    for (KeptAlarm alarm : known)
        if (!among(open.alarms, alarm)) {
            alarm.cleared_at = open.at;
            change(alarm);
        }
    for (const KeptAlarm& alarm : open.alarms)
        if (!among(known, alarm))
            keep(alarm);
}

void History::forget(const std::string& machine) {
    estimates_.forget(machine);
    alarms_.forget(machine);
}

std::vector<KeptAlarm> History::alarms(const std::string& machine, std::uint64_t most) {
    return machine.empty() ? alarms_.rows(newest_alarms_.bind(most)) : alarms_.newest(machine, most);
}

std::vector<KeptAlarm> History::open_alarms() {
    std::vector<KeptAlarm> open = noted_alarms();
    std::erase_if(open, [](const KeptAlarm& alarm) { return alarm.cleared_at.has_value(); });
    return open;
}

} // namespace placedpar::monitor
