#include "explore/study/study_report.hpp"
#include "explore/study/summary_cells.hpp"
#include "text/counted.hpp"
#include "text/user_error.hpp"
#include "text/utf8.hpp"

#include <fmt/format.h>

namespace placedpar {

namespace {

constexpr const char* page_head = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>{0}</title>
<style>
body {{ font: 15px/1.5 system-ui, sans-serif; color: #222; background: #fff; max-width: 62rem; margin: 2rem auto; padding: 0 1rem }}
table {{ border-collapse: collapse; font-variant-numeric: tabular-nums }}
th, td {{ padding: .2rem .8rem; text-align: right; border-bottom: 1px solid #ddd }}
th {{ border-bottom: 2px solid #222 }}
td.ended {{ text-align: left; color: #a00 }}
svg {{ max-width: 100%; height: auto }}
</style>
</head>
<body>
<h1>{0}</h1>
)";

/// Returns the text of an SVG file from the <svg> element on.
std::string inline_svg(const std::string& file) { return file.substr(file.find("<svg")); }

/// Returns the plot, or a paragraph that says why there is no plot.
std::string figure_of(const StudySummary& summary, const std::string& over) {
    try {
        Plot plot = summary_plot(summary, over);
        plot.title.clear(); // the page has a title of its own
        return "<figure>" + inline_svg(draw_svg(plot)) + "</figure>\n";
    } catch (const UserError& none) {
        if (!over.empty())
            throw;
        return fmt::format("<p>{}</p>\n", as_markup(none.what()));
    }
}

std::string element(const std::string& tag, const std::string& text) {
    return fmt::format("<{0}>{1}</{0}>", tag, as_markup(text));
}

std::string head_of_table(const StudySummary& summary) {
    std::string out = "<tr>";
    for (const std::string& axis : summary.axes)
        out += element("th", axis);
    out += "<th>runs</th>";
    const std::string interval = has_intervals(summary) ? "<th>95 %</th>" : "";
    for (std::size_t i = 0; i < summary.measures.size(); ++i)
        out += element("th", measure_with_unit(summary, i)) + interval;
    return out + "<th></th></tr>\n";
}

std::string row_of_table(const StudyLine& line, bool intervals) {
    std::string out = "<tr>";
    for (const std::string& value : line.values)
        out += element("td", value);
    out += fmt::format("<td>{}</td>", line.runs);
    for (const StudyCell& cell : line.cells)
        out += element("td", shown_mean(cell)) + (intervals ? element("td", shown_interval(cell)) : "");
    return out + fmt::format("<td class=\"ended\">{}</td></tr>\n", as_markup(ended_of(line)));
}

std::string table_of(const StudySummary& summary) {
    const bool intervals = has_intervals(summary);
    std::string out = "<table>\n" + head_of_table(summary);
    for (const StudyLine& line : summary.lines)
        out += row_of_table(line, intervals);
    return out + "</table>\n";
}

std::string about_the_runs(const StudySummary& summary) {
    std::string out =
        fmt::format("<p>{} of {}, made by PlacedPar {}.{}</p>\n", counted(summary.runs(), "run"),
                    counted(summary.lines.size(), "combination"), as_markup(summary.version),
                    has_intervals(summary) ? " Intervals are 95 % confidence intervals (Student's t)." : "");
    for (const std::string& each : said_of_all(summary))
        out += element("p", each) + "\n";
    return out;
}

} // namespace

std::string summary_page(const StudySummary& summary, const std::string& over) {
    return fmt::format(page_head, as_markup(summary.netlist)) + about_the_runs(summary) + figure_of(summary, over) +
           table_of(summary) + "</body>\n</html>\n";
}

} // namespace placedpar
