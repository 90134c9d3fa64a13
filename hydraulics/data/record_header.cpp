#include "hydraulics/data/clock_time.hpp"
#include "hydraulics/data/record_table.hpp"
#include "text/nearest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

namespace placedpar::hydraulics {

namespace {

constexpr std::string_view blanks = " \t\r";
constexpr std::size_t most_header_lines = 100; ///< the header must be among this many lines at the beginning

std::string trimmed_text(std::string_view text) {
    const std::size_t first = text.find_first_not_of(blanks);
    return first == text.npos ? "" : std::string(text.substr(first, text.find_last_not_of(blanks) + 1 - first));
}

/// The two parts of "boom.spool [in]" or "boom.spool (in)"; the unit is empty if there are no brackets.
struct NameAndUnit {
    std::string name, unit;
};

NameAndUnit name_and_unit(const std::string& text) {
    const bool round = text.ends_with(')');
    const std::size_t open = round ? text.rfind('(') : text.find('[');
    if (open == text.npos || !(round || text.ends_with(']')))
        return {text, ""};
    std::string unit = trimmed_text(std::string_view(text).substr(open + 1, text.size() - open - 2));
    if (round && !unit_named(unit))
        return {text, ""};
    return {trimmed_text(std::string_view(text).substr(0, open)), std::move(unit)};
}

std::optional<RecordChannel> channel_named(const std::string& name) {
    if (lower_case(name) == "time")
        return RecordChannel{};
    const std::size_t dot = std::min(name.find('.'), name.size());
    const auto link = link_named(name.substr(0, dot));
    const auto sensor = sensor_named(std::string_view(name).substr(std::min(dot + 1, name.size())));
    return link && sensor ? std::optional(RecordChannel{*link, sensor}) : std::nullopt;
}

/// Returns the channel that a user names. A name such as "pressure" is short for the boom's inlet pressure.
std::optional<RecordChannel> channel_typed(std::string name) {
    if (const auto known = channel_named(name))
        return known;
    if (name.find('.') == name.npos)
        name = "boom." + name;
    if (name.ends_with(".pressure"))
        name.insert(name.rfind('.') + 1, "inlet_");
    return channel_named(name);
}

/// Returns the column name that the user gave for a cell of the header, or null.
const ColumnName* typed_name(const std::vector<ColumnName>& names, const std::string& cell) {
    auto found = std::ranges::find_if(names, [&](const ColumnName& each) {
        return each.in_file == cell || each.in_file == name_and_unit(cell).name;
    });
    return found == names.end() ? nullptr : &*found;
}

std::optional<RecordChannel> channel_of(const std::vector<ColumnName>& names, const std::string& cell) {
    if (const ColumnName* typed = typed_name(names, cell))
        return typed->channel;
    auto found = channel_named(name_and_unit(cell).name);
    return found && std::ranges::count(names, *found, &ColumnName::channel) > 0 ? std::nullopt : found;
}

/// Returns the separator that a spreadsheet's line such as "sep=;" states.
std::optional<char> stated_separator(std::string_view line) {
    std::string text = trimmed_text(line.substr(0, 8)); // a tab at the end is a separator, not a blank
    std::erase(text, '"');
    if (!lower_case(text).starts_with("sep="))
        return std::nullopt;
    return text.size() > 4 ? text[4] : '\t';
}

std::string_view first_line(std::string_view text) { return text.substr(0, text.find('\n')); }

int score_of(const std::vector<TextCell>& cells, const std::vector<ColumnName>& names) {
    bool time = false, sensor = false;
    for (const TextCell& cell : cells)
        if (auto channel = channel_of(names, cell.text))
            (channel->sensor ? sensor : time) = true;
    return time ? 1 + sensor : 0;
}

/// The position of the header in the text, and the separator of its columns.
struct HeaderFound {
    std::size_t at = 0;
    char separator = ',';
    int score = -1;        ///< 0: no column is known; 1: the time's column is known; 2: a sensor's column is known, too
    std::size_t cells = 0; ///< number of cells

    /// A higher score is better. At equal scores, more cells are better if both candidates are the same line with
    /// different separators, or if only the time's column is known in both.
    bool is_better_than(const HeaderFound& other) const {
        return score > other.score || (score == other.score && cells > other.cells && (score == 1 || at == other.at));
    }
};

/// Finds the first line with the columns of a record. If no line has them, finds the first line that is not a comment.
HeaderFound find_header(std::string_view text, const std::vector<ColumnName>& names) {
    HeaderFound best{.at = text.size()};
    std::string separators = ",;\t";
    std::size_t at = 0, lines = 0; // number of lines that are not comments
    while (lines < most_header_lines && at < text.size() && best.score < 2) {
        const std::string_view line = first_line(text.substr(at));
        if (const auto stated = stated_separator(line); stated && separators.size() > 1)
            separators = *stated;
        else if (!trimmed_text(line).empty() && !line.starts_with('#')) {
            ++lines;
            for (const char separator : separators) {
                const std::vector<TextCell> cells = split_cells(line, separator);
                const HeaderFound found{at, separator, score_of(cells, names), cells.size()};
                best = found.is_better_than(best) ? found : best;
            }
        }
        at += line.size() + 1;
    }
    return best;
}

bool is_number_or_time(const TextCell& cell) {
    auto is_number = [&cell](char decimal_sign) {
        std::vector<Diagnostic> faults;
        number_in(cell, 0, faults, decimal_sign);
        return faults.empty();
    };
    return is_number('.') || is_number(',') || clock_time(cell.text);
}

/// Returns the text of a cell such as "bar", "[bar]" or "(bar)", without brackets.
std::string without_brackets(const std::string& cell) {
    const bool brackets = cell.size() > 2 && (cell.front() == '[' || cell.front() == '(');
    return brackets ? trimmed_text(std::string_view(cell).substr(1, cell.size() - 2)) : cell;
}

bool is_unit(const TextCell& cell) { return !cell.text.empty() && unit_named(without_brackets(cell.text)) != nullptr; }

} // namespace

ColumnName column_name(std::string_view text) {
    const std::size_t equals = text.find('=');
    auto [name, unit] = name_and_unit(trimmed_text(text.substr(0, equals)));
    const auto channel = channel_typed(name);
    const std::string in_file = equals == text.npos ? "" : trimmed_text(text.substr(equals + 1));
    if (in_file.empty())
        throw UserError(fmt::format("\"{}\": expected NAME=NAME_IN_FILE, such as boom.inlet_pressure=P_boom_in", text));
    if (!channel)
        throw UserError(fmt::format("\"{}\" is not a channel: expected time, LINK.SENSOR such as bucket.angle, or for "
                                    "the boom only the sensor, such as pressure",
                                    name));
    const Quantity quantity = channel->quantity();
    if (const Unit* known = unit_named(unit); !unit.empty() && (!known || known->quantity != quantity))
        throw UserError(
            fmt::format("\"{}\" is not a unit of {}: expected {}", unit, name_of(quantity), list_units(quantity)));
    return {in_file, *channel, unit};
}

/// Finds the header and sets the separator. Returns the text with each line above the header turned into a comment,
/// because a logger describes the record in these lines.
std::string RecordReader::find_table(std::string_view text) {
    if (text.starts_with("\xef\xbb\xbf"))
        text.remove_prefix(3);
    const HeaderFound found = find_header(text, needs_.names);
    table_.separator = found.separator;
    std::string commented;
    for (std::size_t at = 0; at < found.at;) {
        const std::string_view line = first_line(text.substr(at));
        if (!stated_separator(line))
            commented.append(trimmed_text(line).empty() || line.starts_with('#') ? "" : "# ").append(line);
        commented += '\n';
        at += line.size() + 1;
    }
    return commented.append(text.substr(found.at));
}

/// Removes the rows of words below the header. The first row that contains units gives a unit to each column that has
/// no unit in the header.
void RecordReader::take_units_row() {
    const auto first_sample = std::ranges::find_if(
        table_.rows, [](const TextRow& row) { return std::ranges::any_of(row.cells, is_number_or_time); });
    const auto units = std::find_if(table_.rows.begin(), first_sample,
                                    [](const TextRow& row) { return std::ranges::any_of(row.cells, is_unit); });
    if (units == first_sample)
        return;
    for (const TextCell& cell : units->cells)
        units_.push_back(without_brackets(cell.text));
    table_.rows.erase(table_.rows.begin(), first_sample);
}

/// Returns whether a column holds dates with times. The column's first cell with a value decides.
bool RecordReader::has_dates(std::size_t index) const {
    const auto row =
        std::ranges::find_if(table_.rows, [index](const TextRow& each) { return !is_missing(each.cells[index]); });
    return row != table_.rows.end() && clock_time(row->cells[index].text);
}

/// Returns the column's unit, or null after a fault.
const Unit* RecordReader::unit_of(std::size_t index, const RecordChannel& channel,
                                  std::vector<Diagnostic>& faults) const {
    const TextCell& cell = table_.header.cells[index];
    if (!channel.sensor && has_dates(index))
        return unit_named("s");
    const ColumnName* typed = typed_name(needs_.names, cell.text);
    const auto [name, in_header] = name_and_unit(cell.text);
    std::string unit_name = typed ? typed->unit : "";
    if (unit_name.empty())
        unit_name = in_header.empty() && index < units_.size() ? units_[index] : in_header;
    const Unit* unit = unit_named(unit_name);
    if (unit && unit->quantity == channel.quantity())
        return unit;
    faults.push_back(
        error_at(table_.header.line, cell.column,
                 unit_name.empty() ? fmt::format("column \"{}\" has no unit", name)
                                   : fmt::format("\"{}\" is not a unit of {}", unit_name, name_of(channel.quantity())),
                 fmt::format("write {} [UNIT], where UNIT is {}{}", name, list_units(channel.quantity()),
                             channel.sensor ? "" : "; or use dates with times, such as 2024-03-05T14:30:00.020")));
    return nullptr;
}

/// Reads the name and the unit of one column. Adds an unknown name to `unused`.
void RecordReader::read_column(std::size_t index, std::vector<TextCell>& unused, std::vector<Diagnostic>& faults) {
    const TextCell& cell = table_.header.cells[index];
    const std::string name = name_and_unit(cell.text).name;
    const auto channel = channel_of(needs_.names, cell.text);
    if (cell.text == "configuration") {
        configuration_ = index;
        return;
    }
    if (!channel) {
        if (!name.empty())
            unused.push_back({fmt::format("\"{}\"", name), cell.column});
        return;
    }
    const Unit* unit = unit_of(index, *channel, faults);
    if (!unit)
        return;
    auto same = [&](const Column& column) { return RecordChannel{column.link, column.sensor} == *channel; };
    if (auto before = std::ranges::find_if(columns_, same); before != columns_.end())
        faults.push_back(error_at(table_.header.line, cell.column, fmt::format("column \"{}\" occurs twice", name),
                                  fmt::format("the first is column {} of the table", before->index + 1)));
    else
        columns_.push_back({index, cell.column, name, unit, channel->link, channel->sensor});
}

void RecordReader::note_unused(const std::vector<TextCell>& unused, std::vector<Diagnostic>& faults) const {
    constexpr std::size_t most_named = 5;
    if (unused.empty())
        return;
    std::string names;
    for (std::size_t i = 0; i < std::min(unused.size(), most_named); ++i)
        names += (i == 0 ? "" : ", ") + unused[i].text;
    if (unused.size() > most_named)
        names += fmt::format(" and {} more", unused.size() - most_named);
    faults.push_back(warning_at(
        table_.header.line, unused.front().column,
        unused.size() == 1 ? fmt::format("column {} is not used", names)
                           : fmt::format("columns {} are not used", names),
        "columns are time and LINK.SENSOR, such as boom.inlet_pressure or bucket.angle; --column boom.angle=NAME reads "
        "a column of another name"));
}

/// Reports the column names that the user gave and that the file does not contain.
void RecordReader::require_names(std::vector<Diagnostic>& faults) const {
    std::vector<std::string> there;
    for (const TextCell& cell : table_.header.cells)
        if (!cell.text.empty())
            there.push_back(name_and_unit(cell.text).name);
    for (const ColumnName& name : needs_.names)
        if (std::ranges::none_of(table_.header.cells,
                                 [&](const TextCell& cell) { return typed_name(needs_.names, cell.text) == &name; })) {
            const std::string near = did_you_mean(name.in_file, there);
            faults.push_back(error_at(table_.header.line, 1, fmt::format("no column is named \"{}\"", name.in_file),
                                      near.empty() ? fmt::format("the columns are {}", fmt::join(there, ", ")) : near));
        }
}

void RecordReader::read_header(std::vector<Diagnostic>& faults) {
    std::vector<TextCell> unused; // names of the unused columns, in quotes
    take_units_row();
    for (std::size_t i = 0; i < table_.header.cells.size(); ++i)
        read_column(i, unused, faults);
    note_unused(unused, faults);
    require_names(faults);
    if (has_errors(faults))
        return;
    auto time = std::ranges::find_if(columns_, [](const Column& column) { return !column.sensor; });
    if (time == columns_.end())
        faults.push_back(
            error_at(table_.header.line, 1, "the column \"time\" is missing",
                     "add the column time [s], usually the first; or name an existing column: --column time=NAME"));
    else if (columns_.size() == 1)
        faults.push_back(error_at(table_.header.line, 1, "the record has no column of a sensor",
                                  "add a column LINK.SENSOR, such as boom.inlet_pressure [psi]; or name an existing "
                                  "column: --column boom.inlet_pressure=NAME"));
    else
        time->is_clock = has_dates(time->index);
}

} // namespace placedpar::hydraulics
