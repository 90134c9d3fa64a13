#pragma once

#include "hydraulics/data/record.hpp"
#include "hydraulics/data/units.hpp"
#include "text/table.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace placedpar::hydraulics {

/// read_record() makes these checks, one for each common fault of loggers.

/// The position of a channel's name in the text.
struct HeaderPlace {
    std::size_t line, column;
};

struct TimeColumn {
    std::size_t index; ///< index of the column
    HeaderPlace place;
    const Unit& unit; ///< unit in the text
};

/// The last row of the previous piece of text.
struct RowBefore {
    TextRow row;
    double time_s;
};

/// Removes rows that are identical to the row before; loggers write such rows when they restart.
void drop_repeated_rows(TextTable& table, const std::optional<RowBefore>& before, std::vector<Diagnostic>& faults);

/// If record.period_s is 0, sets it to the median step of record.time_s. Checks that the times rise by whole numbers of
/// periods. Times that jitter around whole periods are resampled. Warns of jitter, of gaps, and of a period that is
/// unusual but would be usual in another unit. REQUIRES: the table's rows are the record's samples; there are at least
/// two if record.period_s is 0.
void check_times(Record& record, const TextTable& table, const TimeColumn& time, const std::optional<RowBefore>& before,
                 std::vector<Diagnostic>& faults);

/// Warns of a channel that never changes, and of a channel whose greatest value is unusual but would be usual in
/// another unit. Values are in the unit of units.hpp; `unit` is the unit in the text. REQUIRES: least <= greatest.
void check_channel(std::string_view name, Sensor sensor, const Unit& unit, double least, double greatest,
                   HeaderPlace place, std::vector<Diagnostic>& faults);

/// Warns of pressures below vacuum, at the first sample with such a pressure. `index` is the index of the channel's
/// cells. REQUIRES: the table's rows are the samples.
void check_pressure(std::string_view name, const Unit& unit, std::span<const double> psi, const TextTable& table,
                    std::size_t index, std::vector<Diagnostic>& faults);
/// Warns of readings that freeze and then jump by at least `least_jump`. `period_s` is the time between readings.
/// REQUIRES: the table's rows are the samples.
void check_frozen(std::string_view name, const Unit& unit, std::span<const double> readings, double least_jump,
                  double period_s, const TextTable& table, std::size_t index, std::vector<Diagnostic>& faults);

} // namespace placedpar::hydraulics
