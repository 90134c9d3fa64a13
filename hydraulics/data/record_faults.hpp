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

/// The checks that read_record makes of the measurements, one function for each fault that loggers are known for.

/// Where a channel's name stands in the text.
struct HeaderPlace {
    std::size_t line, column;
};

struct TimeColumn {
    std::size_t index; ///< of the table's cells
    HeaderPlace place;
    const Unit& unit; ///< of the text
};

/// The last row of the piece of text before.
struct RowBefore {
    TextRow row;
    double time_s;
};

/// Removes rows that are identical to the one before, as loggers write them when they restart.
void drop_repeated_rows(TextTable& table, const std::optional<RowBefore>& before, std::vector<Diagnostic>& faults);

/// Sets record.period_s, unless it is above 0, to the median step of record.time_s; the times must rise by whole
/// numbers of periods. Those that jitter about them are resampled. Warns of that, of gaps, and of a period that would
/// be ordinary in another unit. REQUIRES: table's rows are the record's samples, at least two where there is no period.
void check_times(Record& record, const TextTable& table, const TimeColumn& time, const std::optional<RowBefore>& before,
                 std::vector<Diagnostic>& faults);

/// Warns of a channel that never changes, and of one whose greatest value would be ordinary in another unit.
/// Values are in this room's unit, `unit` is the one of the text. REQUIRES: least <= greatest.
void check_channel(std::string_view name, Sensor sensor, const Unit& unit, double least, double greatest,
                   HeaderPlace place, std::vector<Diagnostic>& faults);

/// Warns of a pressure below vacuum, at the first sample that has one. `index`: of the channel's cells.
/// REQUIRES: table's rows are the samples.
void check_pressure(std::string_view name, const Unit& unit, std::span<const double> psi, const TextTable& table,
                    std::size_t index, std::vector<Diagnostic>& faults);
/// Warns of readings, so far apart, that freeze and then jump by so much. The same is required.
void check_frozen(std::string_view name, const Unit& unit, std::span<const double> readings, double least_jump,
                  double period_s, const TextTable& table, std::size_t index, std::vector<Diagnostic>& faults);

} // namespace placedpar::hydraulics
