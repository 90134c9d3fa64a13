#include "explore/study/study_report.hpp"

#include "explore/study/summary_cells.hpp"
#include "text/counted.hpp"
#include "text/paint.hpp"
#include "text/utf8.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar {

namespace {

/// Texts below each other, numbers to the right.
std::string print_rows(const std::vector<std::vector<std::string>>& rows) {
    std::vector<std::size_t> widths(rows.front().size());
    for (const auto& row : rows)
        for (std::size_t i = 0; i + 1 < row.size(); ++i)
            widths[i] = std::max(widths[i], row[i].size());
    std::string out;
    for (std::size_t number = 0; number < rows.size(); ++number) {
        std::string line;
        for (std::size_t i = 0; i < widths.size(); ++i)
            line += fmt::format("{:>{}}  ", rows[number][i], widths[i]);
        line.erase(line.find_last_not_of(' ') + 1);
        out += (number == 0 ? painted(Paint::heading, line) : line) + "\n";
    }
    return out;
}

std::string quoted_csv_cell(const std::string& of) {
    const std::string text = escaped(of);
    if (text.find_first_of(",\"") == text.npos)
        return text;
    std::string out = "\"";
    for (char character : text)
        out += character == '"' ? "\"\"" : std::string(1, character);
    return out + "\"";
}

std::vector<std::string> head_row(const StudySummary& summary, bool intervals) {
    std::vector<std::string> row = summary.axes;
    row.push_back("runs");
    for (std::size_t i = 0; i < summary.measures.size(); ++i) {
        row.push_back(measure_with_unit(summary, i));
        if (intervals)
            row.push_back("95 %");
    }
    row.push_back("");
    return row;
}

std::vector<std::string> row_of(const StudyLine& line, bool intervals) {
    std::vector<std::string> row = line.values;
    row.push_back(fmt::format("{}", line.runs));
    for (const StudyCell& cell : line.cells) {
        row.push_back(shown_mean(cell));
        if (intervals)
            row.push_back(shown_interval(cell));
    }
    row.push_back(ended_of(line));
    return row;
}

std::string print_whole(const StudySummary& summary) {
    std::string out = fmt::format("{}: {} of {}\n", summary.netlist, counted(summary.runs(), "run"),
                                  counted(summary.lines.size(), "combination"));
    for (const std::string& each : said_of_all(summary))
        out += each + "\n";
    return out + "\n";
}

} // namespace

std::string print_summary(const StudySummary& summary) {
    const bool intervals = has_intervals(summary);
    std::vector<std::vector<std::string>> rows{head_row(summary, intervals)};
    for (const StudyLine& line : summary.lines)
        rows.push_back(row_of(line, intervals));
    return print_whole(summary) + print_rows(rows);
}

std::string summary_csv(const StudySummary& summary) {
    std::string out;
    for (const std::string& axis : summary.axes)
        out += quoted_csv_cell(axis) + ",";
    out += "runs,ended";
    for (std::size_t i = 0; i < summary.measures.size(); ++i)
        for (const char* part : {"mean", "half_width_95", "least", "greatest"})
            out += "," + quoted_csv_cell(fmt::format("{} {}", measure_with_unit(summary, i), part));
    for (const StudyLine& line : summary.lines) {
        out += "\n";
        for (const std::string& value : line.values)
            out += quoted_csv_cell(value) + ",";
        out += fmt::format("{},{}", line.runs, quoted_csv_cell(ended_of(line)));
        for (const StudyCell& cell : line.cells)
            out += cell.runs == 0
                       ? ",,,,"
                       : fmt::format(",{},{},{},{}", cell.mean, cell.runs < 2 ? "" : fmt::format("{}", cell.half_width),
                                     cell.least, cell.greatest);
    }
    return out + "\n";
}

} // namespace placedpar
