#pragma once

#include "hydraulics/data/record.hpp"
#include "text/table.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::hydraulics {

struct ReadRecord {
    std::optional<Record> record; ///< none when a fault refuses the text
    std::vector<Diagnostic> faults;
};

/// Reads a record from comma-separated values. The header names each column and its unit, in any order:
///
///     # boom raised at 4 deg/s, seed 1              any number of lines of description
///     time [s],boom.inlet_pressure [psi],boom.angle [deg],boom.spool [in]
///     0.00,1555.1,0.000,0.1297
///
/// Columns: time, and LINK.SENSOR for the four links and the sensors of record.hpp. Any unit of the quantity
/// is converted. A column of another name is warned of and left out.
///
/// Refused: a column or its unit missing, wrong or repeated; no column of a sensor; no number, or one larger than
/// anything measured; times that go back, repeat with other readings, or are further from whole periods apart than
/// jitter_tolerance; a period that changes;
/// fewer than `fewest_samples` rows; what split_table refuses. Warned of: identical rows in succession (used once),
/// jittered times (resampled), gaps, channels that never change, channels and periods that would be ordinary in another
/// unit, pressures below vacuum and frozen ones. Faults come in the order of their lines.
ReadRecord read_record(std::string_view text);

/// The sensors' line fit needs 5 samples.
inline constexpr std::size_t fewest_samples = 5;

/// As read_record reads it, every channel that was measured, in this room's units.
std::string print_record(const Record& record);

} // namespace placedpar::hydraulics
