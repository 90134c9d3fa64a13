#include "monitor/memory/history.hpp"

#include "text/checksum.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace placedpar::monitor {

namespace {

/// SQLite keeps no negative zero.
std::string exact(const std::optional<double>& number) { return number ? fmt::format("{}", *number + 0.0) : "none"; }

std::int64_t checksum_of_row(std::uint64_t number, const KeptEstimate& e) {
    return checksum_of(fmt::format("{}", number), exact(e.at), exact(e.time_s), exact(e.compliance_in3_per_psi),
                       exact(e.error_in3_per_psi), e.machine, e.set, e.link);
}

std::int64_t checksum_of_row(std::uint64_t number, const KeptAlarm& a) {
    return checksum_of(fmt::format("{}", number), exact(a.raised_at), exact(a.raised_time_s), exact(a.cleared_at),
                       exact(a.acknowledged_at), exact(a.shelved_until), a.machine, a.kind, a.links, a.text);
}

// Columns as the statements below select them; the first is the row's number, the last its checksum.
KeptEstimate estimate_of(const store::Statement& row) {
    return {row.text(1), row.number(2), row.number(3), row.text(4), row.text(5), row.number(6), row.optional_number(7)};
}

KeptAlarm alarm_of(const store::Statement& row) {
    return {row.text(1),
            row.text(2),
            row.text(3),
            row.text(4),
            row.number(5),
            row.optional_number(6),
            row.optional_number(7),
            row.optional_number(8),
            row.optional_number(9)};
}

constexpr const char* estimate_columns =
    "SELECT number, machine, at, time_s, population_set, link, compliance, error, checksum FROM estimates ";
constexpr const char* alarm_columns = "SELECT number, machine, kind, links, text, raised_at, raised_time_s, "
                                      "cleared_at, acknowledged_at, shelved_until, checksum FROM alarms ";

void require_whole(bool whole, const char* table, const store::Statement& row) {
    if (!whole)
        throw std::runtime_error(
            fmt::format("row {} of \"{}\" in its table of {} is damaged", row.integer(0), row.text(1), table));
}

} // namespace

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
    : most_(most), next_estimate_(d, "SELECT coalesce(max(number), 0) + 1 FROM estimates WHERE machine = ?1"),
      insert_estimate_(d, "INSERT INTO estimates VALUES(?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9)"),
      trim_estimates_(d, "DELETE FROM estimates WHERE machine = ?1 AND number <= ?2"),
      select_estimates_(d, fmt::format("{}WHERE machine = ?1 ORDER BY number DESC LIMIT ?2", estimate_columns)),
      all_estimates_(d, estimate_columns),
      next_alarm_(d, "SELECT coalesce(max(number), 0) + 1 FROM alarms WHERE machine = ?1"),
      insert_alarm_(d, "INSERT INTO alarms VALUES(?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10, ?11)"),
      trim_alarms_(d, "DELETE FROM alarms WHERE machine = ?1 AND number <= ?2"),
      find_alarm_(d, fmt::format("{}WHERE machine = ?1 AND kind = ?2 AND links = ?3 ORDER BY number DESC LIMIT 1",
                                 alarm_columns)),
      update_alarm_(d, "UPDATE alarms SET cleared_at = ?3, acknowledged_at = ?4, shelved_until = ?5, checksum = ?6 "
                       "WHERE machine = ?1 AND number = ?2"),
      select_alarms_(d, fmt::format("{}WHERE machine = ?1 ORDER BY number DESC LIMIT ?2", alarm_columns)),
      newest_alarms_(d, fmt::format("{}ORDER BY raised_at DESC, machine, number DESC LIMIT ?1", alarm_columns)),
      all_alarms_(d, alarm_columns),
      noted_alarms_(d, fmt::format("{}WHERE cleared_at IS NULL OR shelved_until IS NOT NULL ORDER BY machine, number",
                                   alarm_columns)),
      forget_estimates_(d, "DELETE FROM estimates WHERE machine = ?1"),
      forget_alarms_(d, "DELETE FROM alarms WHERE machine = ?1") {}

void History::check() {
    all_estimates_.bind();
    while (all_estimates_.step())
        require_whole(checksum_of_row(static_cast<std::uint64_t>(all_estimates_.integer(0)),
                                      estimate_of(all_estimates_)) == all_estimates_.integer(8),
                      "estimates", all_estimates_);
    all_alarms_.bind();
    while (all_alarms_.step())
        require_whole(checksum_of_row(static_cast<std::uint64_t>(all_alarms_.integer(0)), alarm_of(all_alarms_)) ==
                          all_alarms_.integer(10),
                      "alarms", all_alarms_);
}

void History::keep(const KeptEstimate& e) {
    auto number = static_cast<std::uint64_t>(next_estimate_.only_integer(e.machine));
    insert_estimate_.run(e.machine, number, e.at, e.time_s, e.set, e.link, e.compliance_in3_per_psi,
                         e.error_in3_per_psi, checksum_of_row(number, e));
    if (number > most_)
        trim_estimates_.run(e.machine, number - most_);
}

void History::keep(const KeptAlarm& a) {
    auto number = static_cast<std::uint64_t>(next_alarm_.only_integer(a.machine));
    insert_alarm_.run(a.machine, number, a.kind, a.links, a.text, a.raised_at, a.raised_time_s, a.cleared_at,
                      a.acknowledged_at, a.shelved_until, checksum_of_row(number, a));
    if (number > most_)
        trim_alarms_.run(a.machine, number - most_);
}

void History::change(const KeptAlarm& a) {
    if (!find_alarm_.bind(a.machine, a.kind, a.links).step())
        return; // so old that it has been trimmed
    auto number = static_cast<std::uint64_t>(find_alarm_.integer(0));
    KeptAlarm changed = alarm_of(find_alarm_);
    changed.cleared_at = a.cleared_at;
    changed.acknowledged_at = a.acknowledged_at;
    changed.shelved_until = a.shelved_until;
    find_alarm_.reset();
    update_alarm_.run(a.machine, number, changed.cleared_at, changed.acknowledged_at, changed.shelved_until,
                      checksum_of_row(number, changed));
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
    forget_estimates_.run(machine);
    forget_alarms_.run(machine);
}

std::vector<KeptEstimate> History::estimates(const std::string& machine, std::uint64_t most) {
    std::vector<KeptEstimate> found;
    select_estimates_.bind(machine, most);
    while (select_estimates_.step())
        found.push_back(estimate_of(select_estimates_));
    return found;
}

std::vector<KeptAlarm> History::alarms(const std::string& machine, std::uint64_t most) {
    std::vector<KeptAlarm> found;
    store::Statement& rows = machine.empty() ? newest_alarms_.bind(most) : select_alarms_.bind(machine, most);
    while (rows.step())
        found.push_back(alarm_of(rows));
    return found;
}

std::vector<KeptAlarm> History::open_alarms() {
    std::vector<KeptAlarm> open = noted_alarms();
    std::erase_if(open, [](const KeptAlarm& alarm) { return alarm.cleared_at.has_value(); });
    return open;
}

std::vector<KeptAlarm> History::noted_alarms() {
    std::vector<KeptAlarm> found;
    noted_alarms_.bind();
    while (noted_alarms_.step())
        found.push_back(alarm_of(noted_alarms_));
    return found;
}

} // namespace placedpar::monitor
