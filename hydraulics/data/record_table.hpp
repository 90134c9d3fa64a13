#pragma once

#include "hydraulics/data/record.hpp"
#include "hydraulics/data/record_faults.hpp"
#include "text/table.hpp"

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace placedpar::hydraulics {

struct ReadRecord {
    std::optional<Record> record; ///< none when a fault refuses the text
    std::vector<Diagnostic> faults;
};

/// What a record is read for.
struct RecordNeeds {
    /// Of the channels that a header names, those that must have a value in every row; all of them if not given.
    std::function<ChannelSet(const ChannelSet&)> of = {};
    /// Leaves rows out that lack one, in place of refusing the record.
    bool skip_missing = false;
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
/// A channel that is not needed and has an empty cell is left out.
///
/// Refused: a column or its unit missing, wrong or repeated; no column of a sensor; no number, or one larger than
/// anything measured; times that go back, repeat with other readings, or are further from whole periods apart than
/// jitter_tolerance; a period that changes;
/// fewer than `fewest_samples` rows; what split_table refuses. Warned of: identical rows in succession (used once),
/// jittered times (resampled), gaps, channels that never change, channels and periods that would be ordinary in another
/// unit, pressures below vacuum and frozen ones. Faults come in the order of their lines.
ReadRecord read_record(std::string_view text, const RecordNeeds& needs = {});

/// The same, of a text of any length, piece by piece.
class RecordReader {
public:
    explicit RecordReader(RecordNeeds needs = {}) : needs_(std::move(needs)) {}

    /// Reads the next whole lines of the text. The period is the first piece's. Warnings of the header come once; no
    /// record when a fault refuses the piece, and then the reader is not to be used any more.
    ReadRecord read(std::string_view lines);
    /// The text is over: what is to be said of whole channels.
    std::vector<Diagnostic> finish() const;

private:
    /// What a column of the text holds.
    struct Column {
        std::size_t index;
        std::size_t at; ///< column of its name in the header's line
        std::string name;
        const Unit* unit;
        Link link{};
        std::optional<Sensor> sensor = {}; ///< none: the time
        bool needed = true;
        double least = std::numeric_limits<double>::infinity(), greatest = -least; ///< so far

        std::vector<double>& of(Record& record) const { return sensor ? record.of(link, *sensor) : record.time_s; }
    };

    bool read_table(std::string_view lines, std::vector<Diagnostic>& faults);
    Record read_piece(std::vector<Diagnostic>& faults);
    void read_header(std::vector<Diagnostic>& faults);
    void find_needs();
    void skip_missing(std::vector<Diagnostic>& faults);
    double value_in(const TextRow& row, const Column& column, std::vector<Diagnostic>& faults) const;
    void read_rows(Record& record, std::vector<Diagnostic>& faults);
    void check(Record& record, std::vector<Diagnostic>& faults);
    void check_readings(const Column& column, Record& record, std::vector<Diagnostic>& faults) const;
    void forget_told(std::vector<Diagnostic>& faults);

    RecordNeeds needs_;
    TextTable table_;      ///< the rows of the newest piece
    std::size_t line_ = 1; ///< the next
    std::vector<Column> columns_;
    std::optional<RowBefore> before_;
    std::optional<double> period_s_;
    std::set<std::size_t> told_; ///< columns of the header that have been warned of
};

/// The sensors' line fit needs 5 samples.
inline constexpr std::size_t fewest_samples = 5;

/// As read_record reads it, every channel that was measured, in this room's units.
std::string print_record(const Record& record);

} // namespace placedpar::hydraulics
