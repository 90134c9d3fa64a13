#pragma once

#include "hydraulics/data/record.hpp"
#include "hydraulics/data/record_faults.hpp"
#include "text/table.hpp"

#include <cstddef>
#include <cstdint>
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
    std::optional<Record> record; ///< nullopt if a fault made the text unusable
    std::vector<Diagnostic> faults;
};

/// What a column of a record's file holds: the time, or the readings of one sensor of one link.
struct RecordChannel {
    Link link{};
    std::optional<Sensor> sensor = std::nullopt; ///< nullopt: the time

    Quantity quantity() const { return sensor ? quantity_of(*sensor) : Quantity::time; }
    friend bool operator==(const RecordChannel&, const RecordChannel&) = default;
};

/// A column whose name in the file is not the name of its channel.
struct ColumnName {
    std::string in_file; ///< name of the column in the file, with or without its unit
    RecordChannel channel;
    std::string unit; ///< replaces the unit in the file; "": the unit in the file
};

/// Reads a text of the user, such as "boom.inlet_pressure=P_boom_in", "angle [deg]=Phi 1" or "time=Timestamp". A sensor
/// without a link is the boom's. The unit may be left out if the file has it. Throws UserError.
ColumnName column_name(std::string_view text);

/// States which channels a record must have.
struct RecordNeeds {
    /// Given the channels that a header names, returns the channels that must have a value in every row. Without this
    /// function, every channel must have a value in every row.
    std::function<ChannelSet(const ChannelSet&)> of = {};
    /// true: rows that lack a required value are left out; false: the record is refused.
    bool skip_missing = false;
    std::vector<ColumnName> names = {};
};

/// Reads a record from a text of rows, whose values commas, semicolons or tabs separate. A line "sep=;" states the
/// separator. Without such a line, the separator is the sign that divides the header into the most columns. Numbers may
/// have decimal commas. The header is the first line that names the time and a sensor. The lines above it are the
/// description. The header names each column and its unit, in any order; instead, the units may be in a row below the
/// header:
///
///     # boom raised at 4 deg/s, seed 1              any number of lines of description
///     time [s],boom.inlet_pressure [psi],boom.angle [deg],boom.spool [in]
///     0.00,1555.1,0.000,0.1297
///
/// A column's name is "time", or LINK.SENSOR with one of the four links and a sensor of record.hpp. Any unit of the
/// quantity is converted. The time may also be a date and time of ISO 8601, which is converted to seconds from the
/// first instant. A column "configuration" has the letter a to e of the main valve's configuration, or any other text
/// if the configuration is unknown. A column with another name causes a warning and is ignored. A channel with an empty
/// cell is ignored too, if `needs` does not require the channel.
///
/// The text is refused if: a column or its unit is missing, wrong or repeated; there is no sensor column; a value is
/// not a number or larger than any measurement; times go back, repeat with other readings, or deviate from whole
/// periods by more than jitter_tolerance; the period changes; there are fewer than `fewest_samples` rows; or
/// split_table() (text/table.hpp) refuses it. Warnings report: successive identical rows (used once), jittered times
/// (resampled), gaps, channels that never change, values and periods that would be usual in another unit, pressures
/// below vacuum, and pressures and angles that freeze and then jump. Faults are in the order of their lines.
ReadRecord read_record(std::string_view text, const RecordNeeds& needs = {});

/// Reads a long text in pieces, so that the program need not hold the whole text. The results are those of
/// read_record() for the whole text.
class RecordReader {
public:
    explicit RecordReader(RecordNeeds needs = {}) : needs_(std::move(needs)) {}

    /// Reads the next lines of the text. REQUIRES: `lines` ends at the end of a line. The first piece determines the
    /// period. Warnings about the header are given once. If a fault makes the piece unusable, the result has no record,
    /// and the caller must not use the reader any more.
    ReadRecord read(std::string_view lines);
    /// Returns the warnings about whole channels, and about all rows that were left out, at the end of the text.
    std::vector<Diagnostic> finish() const;
    /// Returns the date at which the record's time is 0, in s since 1970. Returns nullopt if the file has no dates or
    /// no piece was read.
    std::optional<double> begun_s() const;

private:
    struct Column {
        std::size_t index;
        std::size_t at; ///< position of the column's name in the header's line
        std::string name;
        const Unit* unit;
        Link link{};
        std::optional<Sensor> sensor = {}; ///< nullopt: the time
        bool needed = true;
        bool is_clock = false;                                                     ///< the cells are dates and times
        double least = std::numeric_limits<double>::infinity(), greatest = -least; ///< range of the values so far

        std::vector<double>& of(Record& record) const { return sensor ? record.of(link, *sensor) : record.time_s; }
    };

    /// Returns whether the cell is one of the words that loggers write for a missing reading.
    static bool is_missing(const TextCell& cell);

    bool read_table(std::string_view lines, std::vector<Diagnostic>& faults);
    Record read_piece(std::vector<Diagnostic>& faults);
    std::string find_table(std::string_view text);
    void take_units_row();
    bool has_dates(std::size_t index) const;
    const Unit* unit_of(std::size_t index, const RecordChannel& channel, std::vector<Diagnostic>& faults) const;
    void read_column(std::size_t index, std::vector<TextCell>& unused, std::vector<Diagnostic>& faults);
    void note_unused(const std::vector<TextCell>& unused, std::vector<Diagnostic>& faults) const;
    void require_names(std::vector<Diagnostic>& faults) const;
    void read_header(std::vector<Diagnostic>& faults);
    void find_needs();
    void find_decimal_sign(std::vector<Diagnostic>& faults);
    double clock_s(const TextRow& row, const Column& column, std::vector<Diagnostic>& faults);
    void skip_missing();
    double value_in(const TextRow& row, const Column& column, std::vector<Diagnostic>& faults);
    void read_rows(Record& record, std::vector<Diagnostic>& faults);
    void check(Record& record, std::vector<Diagnostic>& faults);
    void check_readings(const Column& column, Record& record, std::vector<Diagnostic>& faults) const;
    void forget_told(std::vector<Diagnostic>& faults);

    RecordNeeds needs_;
    TextTable table_;                ///< the rows of the newest piece
    std::size_t line_ = 1;           ///< number of the next line
    std::vector<std::string> units_; ///< the cells of a row of units below the header
    std::vector<Column> columns_;
    std::optional<char> decimal_sign_;         ///< nullopt until a number has a decimal point or a decimal comma
    std::optional<std::int64_t> begun_ns_;     ///< the first date, in ns since 1970
    bool has_zone_ = false;                    ///< whether the dates have a zone
    std::optional<std::size_t> configuration_; ///< index of the column of the configurations
    std::size_t skipped_ = 0, first_skipped_line_ = 0; ///< rows that lack a reading
    std::optional<RowBefore> before_;
    std::optional<double> period_s_;
    std::set<std::size_t> told_; ///< positions in the header of the columns about which a warning was given
};

/// The least number of samples in a record: slopes come from lines fitted to 5 samples.
inline constexpr std::size_t fewest_samples = 5;

/// Returns a text that read_record reads, with every measured channel in the unit of units.hpp.
std::string print_record(const Record& record);

} // namespace placedpar::hydraulics
