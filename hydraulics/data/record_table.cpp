#include "hydraulics/data/record_table.hpp"

#include "hydraulics/data/clock_time.hpp"
#include "hydraulics/data/frozen_run.hpp"
#include "text/counted.hpp"
#include "text/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <regex>

namespace placedpar::hydraulics {

namespace {

/// Returns the number of decimals, 3 to 9, that shows all times without rounding.
int time_decimals(const Record& record) {
    int decimals = 3;
    for (double scale = 1e3; decimals < 9; ++decimals, scale *= 10)
        if (std::ranges::all_of(record.time_s, [scale](double time_s) {
                return std::abs(time_s * scale - std::round(time_s * scale)) < 1e-3;
            }))
            break;
    return decimals;
}

/// Prints a number, but "0.000" instead of "-0.000". The sign of such a number may differ between computers.
std::string print_number(double value, int decimals) {
    std::string text = fmt::format("{:.{}f}", value, decimals);
    bool zero = text.find_first_not_of("-0.") == std::string::npos;
    return zero && text.front() == '-' ? text.substr(1) : text;
}

/// Returns whether the commas in a number may separate thousands, as in "1,567" or "-12,000". In "1,567" the comma may
/// instead be a decimal comma.
bool has_thousands(const std::string& text) {
    static const std::regex thousands("[-+]?[1-9][0-9]{0,2}(,[0-9]{3})+");
    constexpr std::size_t longest = 40; // the library's matcher needs much stack for a long text
    return text.size() <= longest && std::regex_match(text, thousands);
}

Diagnostic thousands_fault(const TextCell& cell, std::size_t line) {
    std::string without = cell.text, point = cell.text;
    std::erase(without, ',');
    point[point.rfind(',')] = '.';
    std::erase(point, ',');
    return error_at(line, cell.column, fmt::format("{} may be {} or {}", cell.text, without, point),
                    "write numbers without thousands separators; one number such as 0,5 shows that commas are decimal");
}

} // namespace

bool RecordReader::is_missing(const TextCell& cell) {
    constexpr std::array<std::string_view, 15> words{"",     "-",        "--",        "nan",     "-nan",
                                                     "na",   "n/a",      "#n/a",      "#nv",     "none",
                                                     "null", "nan(ind)", "-nan(ind)", "1.#qnan", "-1.#ind"};
    return cell.text.size() <= words.back().size() + 2 &&
           std::ranges::find(words, lower_case(cell.text)) != words.end();
}

void RecordReader::find_needs() {
    ChannelSet there;
    for (const Column& column : columns_)
        if (column.sensor)
            there.insert(column.link, *column.sensor);
    const ChannelSet needed = needs_.of ? needs_.of(there) : there;
    for (Column& column : columns_)
        column.needed = !column.sensor || needed.contains(column.link, *column.sensor);
}

/// Removes the rows that lack a needed reading.
void RecordReader::skip_missing() {
    auto lacks = [&](const TextRow& row) {
        return std::ranges::any_of(
            columns_, [&](const Column& column) { return column.needed && is_missing(row.cells[column.index]); });
    };
    if (auto first = std::ranges::find_if(table_.rows, lacks); skipped_ == 0 && first != table_.rows.end())
        first_skipped_line_ = first->line;
    skipped_ += std::erase_if(table_.rows, lacks);
}

/// Finds out whether numbers have decimal commas or decimal points. The last such sign in the first number with a comma
/// or a point is the decimal sign. A number decides nothing if three digits follow each comma, because these commas may
/// separate thousands.
void RecordReader::find_decimal_sign(std::vector<Diagnostic>& faults) {
    const TextCell* unclear = nullptr;
    std::size_t line = 0;
    for (const TextRow& row : table_.rows)
        for (const Column& column : columns_) {
            const TextCell& cell = row.cells[column.index];
            const std::size_t sign =
                column.is_clock || is_missing(cell) ? cell.text.npos : cell.text.find_last_of(".,");
            if (sign == cell.text.npos || (unclear && cell.text[sign] != ','))
                continue;
            decimal_sign_ = cell.text[sign];
            if (!has_thousands(cell.text))
                return;
            if (!unclear)
                unclear = &cell, line = row.line;
        }
    if (unclear)
        faults.push_back(thousands_fault(*unclear, line));
}

/// Returns the time of the row, in seconds after the first date.
double RecordReader::clock_s(const TextRow& row, const Column& column, std::vector<Diagnostic>& faults) {
    const TextCell& cell = row.cells[column.index];
    const std::optional<ClockTime> time = clock_time(cell.text);
    if (time && !begun_ns_)
        begun_ns_ = time->since_1970_ns, has_zone_ = time->has_zone;
    if (time && time->has_zone == has_zone_)
        return static_cast<double>(time->since_1970_ns - *begun_ns_) / 1e9;
    faults.push_back(error_at(
        row.line, cell.column,
        !time       ? fmt::format("\"{}\" is not a date and time of ISO 8601", cell.text)
        : has_zone_ ? fmt::format("{} has no time zone, unlike the times before it", cell.text)
                    : fmt::format("{} has a time zone, unlike the times before it", cell.text),
        "write times such as 2024-03-05T14:30:00.020, or all with a zone, such as 2024-03-05T14:30:00.020+01:00"));
    return 0;
}

/// Returns the value in the unit of units.hpp.
double RecordReader::value_in(const TextRow& row, const Column& column, std::vector<Diagnostic>& faults) {
    const TextCell& cell = row.cells[column.index];
    if (is_missing(cell)) {
        faults.push_back(
            error_at(row.line, cell.column,
                     cell.text.empty() ? "the value is missing" : fmt::format("\"{}\" is not a reading", cell.text),
                     "write a number such as 1830.5 or -2e-3; \"placedpar identify --missing skip\" leaves out rows "
                     "with missing readings"));
        return 0;
    }
    if (column.is_clock)
        return clock_s(row, column, faults);
    double value = number_in(cell, row.line, faults, decimal_sign_.value_or('.')) * column.unit->factor;
    if (std::abs(value) <= largest_reading)
        return value;
    faults.push_back(error_at(row.line, cell.column, fmt::format("{} is too large for a reading", cell.text),
                              "leave a row out where a reading is missing"));
    return 0;
}

void RecordReader::read_rows(Record& record, std::vector<Diagnostic>& faults) {
    auto lacks = [](const Column& column) {
        return [&column](const TextRow& row) { return is_missing(row.cells[column.index]); };
    };
    if (!decimal_sign_)
        find_decimal_sign(faults);
    for (const TextRow& row : table_.rows)
        if (configuration_) {
            const std::string& cell = row.cells[*configuration_].text;
            record.configuration += cell.size() == 1 && cell[0] >= 'a' && cell[0] <= 'e' ? cell[0] : '-';
        }
    for (Column& column : columns_) {
        if (!column.needed && std::ranges::any_of(table_.rows, lacks(column)))
            continue;
        std::vector<double>& values = column.of(record);
        for (const TextRow& row : table_.rows)
            values.push_back(value_in(row, column, faults));
        auto [least, greatest] = std::ranges::minmax_element(values);
        column.least = std::min(column.least, *least);
        column.greatest = std::max(column.greatest, *greatest);
    }
}

void RecordReader::check_readings(const Column& column, Record& record, std::vector<Diagnostic>& faults) const {
    const std::vector<double>& readings = column.of(record);
    if (quantity_of(*column.sensor) == Quantity::pressure) {
        check_pressure(column.name, *column.unit, readings, table_, column.index, faults);
        check_frozen(column.name, *column.unit, readings, least_jump_psi, record.period_s, table_, column.index,
                     faults);
    }
    if (*column.sensor == Sensor::angle)
        check_frozen(column.name, *column.unit, readings, least_jump_deg, record.period_s, table_, column.index,
                     faults);
}

void RecordReader::check(Record& record, std::vector<Diagnostic>& faults) {
    RowBefore last{table_.rows.back(), record.time_s.back()}; // before check_times() resamples the times
    const auto time =
        std::ranges::find_if(columns_, [](const Column& each) { return !each.sensor; }); // the column of the time
    check_times(record, table_, {time->index, {table_.header.line, time->at}, *time->unit}, before_, faults);
    for (const Column& column : columns_)
        if (column.sensor && record.period_s > 0 && record.has(column.link, *column.sensor))
            check_readings(column, record, faults);
    if (has_errors(faults)) // the warnings about whole channels may explain these faults
        std::ranges::move(finish(), std::back_inserter(faults));
    before_ = std::move(last);
    period_s_ = record.period_s;
}

/// Removes warnings about the header that an earlier piece of the file has already caused.
void RecordReader::forget_told(std::vector<Diagnostic>& faults) {
    std::set<std::size_t> now = told_;
    std::erase_if(faults, [&](const Diagnostic& fault) {
        bool of_header = fault.severity == Severity::warning && fault.location.line == table_.header.line;
        if (of_header)
            now.insert(fault.location.column);
        return of_header && told_.contains(fault.location.column);
    });
    told_ = std::move(now);
}

/// Reads the lines into table_, and the header of the first piece. Returns false if nothing can be read.
bool RecordReader::read_table(std::string_view lines, std::vector<Diagnostic>& faults) {
    table_.rows.clear();
    line_ = columns_.empty() ? append_lines(table_, find_table(lines), line_, faults)
                             : append_lines(table_, lines, line_, faults);
    if (table_.rows.empty() && has_errors(faults))
        return false;
    if (table_.header.cells.empty()) {
        faults.push_back(
            error_at(0, 0, "the header is missing", "write a header such as time [s],boom.inlet_pressure [psi]"));
        return false;
    }
    if (table_.rows.empty() && !before_) { // only a header, or a file whose line ends were lost
        faults.push_back(error_at(0, 0, fmt::format("the record has 0 samples, expected at least {}", fewest_samples),
                                  "write a line for each instant below the header; lines end in LF or in CR LF"));
        return false;
    }
    if (!columns_.empty())
        return true;
    std::vector<Diagnostic> of_header;
    read_header(of_header);
    faults.insert(faults.end(), of_header.begin(), of_header.end());
    if (!has_errors(of_header))
        find_needs();
    return !has_errors(of_header);
}

Record RecordReader::read_piece(std::vector<Diagnostic>& faults) {
    Record record;
    record.description = table_.description;
    record.period_s = period_s_.value_or(0);
    if (!table_.rows.empty())
        read_rows(record, faults);
    if (has_errors(faults))
        return record;
    if (!before_ && record.size() < fewest_samples)
        faults.push_back(error_at(
            0, 0, fmt::format("the sample count is {}, expected at least {}", record.size(), fewest_samples), ""));
    else if (record.size() > 0)
        check(record, faults);
    return record;
}

ReadRecord RecordReader::read(std::string_view lines) {
    ReadRecord read;
    if (!read_table(lines, read.faults))
        return read;
    drop_repeated_rows(table_, before_, read.faults);
    if (needs_.skip_missing)
        skip_missing();
    Record record = read_piece(read.faults);
    forget_told(read.faults);
    std::ranges::stable_sort(read.faults, {}, [](const Diagnostic& fault) { return fault.location.line; });
    if (!has_errors(read.faults))
        read.record = std::move(record);
    return read;
}

std::vector<Diagnostic> RecordReader::finish() const {
    std::vector<Diagnostic> faults;
    if (skipped_ > 0)
        faults.push_back(warning_at(first_skipped_line_, 1,
                                    skipped_ == 1 ? "a reading is missing" : "readings are missing",
                                    fmt::format("{} left out, beginning with this row", counted(skipped_, "row"))));
    for (const Column& column : columns_)
        if (column.sensor && column.least <= column.greatest)
            check_channel(column.name, *column.sensor, *column.unit, column.least, column.greatest,
                          {table_.header.line, column.at}, faults);
    return faults;
}

std::optional<double> RecordReader::begun_s() const {
    return begun_ns_ ? std::optional(static_cast<double>(*begun_ns_) / 1e9) : std::nullopt;
}

ReadRecord read_record(std::string_view text, const RecordNeeds& needs) {
    RecordReader reader(needs);
    ReadRecord read = reader.read(text);
    if (!read.record)
        return read;
    for (Diagnostic& fault : reader.finish())
        read.faults.push_back(std::move(fault));
    std::ranges::stable_sort(read.faults, {}, [](const Diagnostic& fault) { return fault.location.line; });
    return read;
}

std::string print_record(const Record& record) {
    struct Printed {
        const std::vector<double>* values;
        int decimals;
    };
    std::string text, description = record.description;
    for (std::size_t end; !description.empty(); description.erase(0, end + 1)) {
        end = std::min(description.find('\n'), description.size() - 1);
        text += fmt::format("# {}", description.substr(0, end + 1));
    }
    if (!text.empty() && text.back() != '\n')
        text += '\n';
    std::vector<Printed> channels{{&record.time_s, time_decimals(record)}};
    text += "time [s]";
    for (Link link : all_links)
        for (Sensor sensor : all_sensors)
            if (record.has(link, sensor)) {
                text += fmt::format(",{}.{} [{}]", name_of(link), name_of(sensor),
                                    units_of(quantity_of(sensor)).front().name);
                channels.push_back({&record.of(link, sensor), quantity_of(sensor) == Quantity::pressure ? 4 : 7});
            }
    text += record.configuration.empty() ? "\n" : ",configuration\n";
    for (std::size_t i = 0; i < record.size(); ++i) {
        for (std::size_t c = 0; c < channels.size(); ++c)
            text += (c == 0 ? "" : ",") + print_number((*channels[c].values)[i], channels[c].decimals);
        text += record.configuration.empty() ? "\n" : fmt::format(",{}\n", record.configuration[i]);
    }
    return text;
}

} // namespace placedpar::hydraulics
