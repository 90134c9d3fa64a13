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

/// These functions check a record's file for common faults of loggers. read_record() calls them.

/// The position of a channel's name in the text.
struct HeaderPlace {
    std::size_t line, column;
};

struct TimeColumn {
    std::size_t index; ///< index of the column
    HeaderPlace place;
    const Unit& unit; ///< unit in the text
};

/// The last row of the previous piece of text, if a file is read in pieces.
struct RowBefore {
    TextRow row;
    double time_s;
};

/// Removes rows that are identical to the row before. Loggers write such rows when they restart.
void drop_repeated_rows(TextTable& table, const std::optional<RowBefore>& before, std::vector<Diagnostic>& faults);

/// Checks that the times rise by whole numbers of periods. If record.period_s is 0, first sets it to the median step of
/// record.time_s. If the times jitter around whole periods, resamples the readings. Warns of jitter, of gaps, and of a
/// period that looks like a time in another unit. REQUIRES: the table's rows are the record's samples; there are at
/// least two if record.period_s is 0.
void check_times(Record& record, const TextTable& table, const TimeColumn& time, const std::optional<RowBefore>& before,
                 std::vector<Diagnostic>& faults);

/// Warns of a channel that never changes. Also warns of a channel whose greatest value is unusual but would be usual in
/// another unit. `least` and `greatest` are in the unit of units.hpp; `unit` is the unit in the text. REQUIRES: least
/// <= greatest.
void check_channel(std::string_view name, Sensor sensor, const Unit& unit, double least, double greatest,
                   HeaderPlace place, std::vector<Diagnostic>& faults);

/// Warns of pressures below vacuum, at the first sample with such a pressure. `index` is the index of the channel's
/// cell in a row. REQUIRES: the table's rows are the samples.
void check_pressure(std::string_view name, const Unit& unit, std::span<const double> psi, const TextTable& table,
                    std::size_t index, std::vector<Diagnostic>& faults);
/// Warns of readings that stay equal for a while and then jump by at least `least_jump`, as a faulty sensor's do.
/// REQUIRES: the table's rows are the samples.
void check_frozen(std::string_view name, const Unit& unit, std::span<const double> readings, double least_jump,
                  double period_s, const TextTable& table, std::size_t index, std::vector<Diagnostic>& faults);

} // namespace placedpar::hydraulics
