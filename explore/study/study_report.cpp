#include "explore/study/study_report.hpp"

#include "explore/study/summary_cells.hpp"
#include "report/field.hpp"
#include "text/counted.hpp"

#include <fmt/format.h>

namespace placedpar {

namespace {

/// Returns a row of the table. How the runs ended is the last column of the printed table, but comes before the
/// measures in CSV.
Row row_of(const StudySummary& summary, const StudyLine& line, bool intervals) {
    Row row;
    for (std::size_t i = 0; i < summary.axes.size(); ++i)
        row.push_back(Field::right(0, summary.axes[i], line.values[i]).as(summary.axes[i]));
    row.push_back(Field::right(0, "runs", fmt::format("{}", line.runs)).as("runs", line.runs));
    row.push_back(Field::member("ended", ended_of(line)));
    for (std::size_t i = 0; i < summary.measures.size(); ++i) {
        const StudyCell& cell = line.cells[i];
        const std::string name = measure_with_unit(summary, i);
        auto known = [&](double figure, std::uint64_t runs) {
            return cell.runs < runs ? boost::json::value() : boost::json::value(figure);
        };
        row.push_back(Field::right(0, name, shown_mean(cell)).as(name + " mean", known(cell.mean, 1)));
        row.push_back(Field::right(0, "95 %", shown_interval(cell))
                          .as(name + " half_width_95", known(cell.half_width, 2))
                          .shown_if(intervals));
        row.push_back(Field::member(name + " least", known(cell.least, 1)));
        row.push_back(Field::member(name + " greatest", known(cell.greatest, 1)));
    }
    row.push_back(Field::left(0, "", ended_of(line)));
    return row;
}

Table lines_of(const StudySummary& summary) {
    return table_of(summary.lines, [&, intervals = has_intervals(summary)](StudyLine line) {
        line.values.resize(summary.axes.size());
        line.cells.resize(summary.measures.size());
        return row_of(summary, line, intervals);
    });
}

std::string print_whole(const StudySummary& summary) {
    std::string out = fmt::format("{}: {} of {}\n", summary.netlist, counted(summary.runs(), "run"),
                                  counted(summary.lines.size(), "combination"));
    for (const std::string& each : said_of_all(summary))
        out += each + "\n";
    return out + "\n";
}

struct RowOfRun {
    std::vector<std::string> values; ///< values of the axes
    StudiedRun run;
};

Row row_of(const StudySummary& summary, const RowOfRun& of) {
    Row row;
    for (std::size_t i = 0; i < summary.axes.size(); ++i)
        row.push_back(Field::member(summary.axes[i], of.values[i]));
    for (const auto& [name, value] : summary.fixed)
        row.push_back(Field::member(name, value));
    row.push_back(Field::member("seed", of.run.seed));
    row.push_back(Field::member("ended", of.run.ended));
    for (std::size_t i = 0; i < summary.measures.size(); ++i) {
        const auto& figure = of.run.figures[i];
        row.push_back(
            Field::member(measure_with_unit(summary, i), figure ? boost::json::value(*figure) : boost::json::value()));
    }
    return row;
}

} // namespace

std::string runs_csv(const StudySummary& summary) {
    std::vector<RowOfRun> runs;
    for (const StudyLine& line : summary.lines)
        for (const StudiedRun& each : line.each)
            runs.push_back({line.values, each});
    return table_of(runs,
                    [&](RowOfRun of) {
                        of.values.resize(summary.axes.size());
                        of.run.figures.resize(summary.measures.size());
                        return row_of(summary, of);
                    })
        .csv();
}

std::string print_summary(const StudySummary& summary) { return print_whole(summary) + lines_of(summary).text(); }

std::string summary_csv(const StudySummary& summary) { return lines_of(summary).csv(); }

} // namespace placedpar
