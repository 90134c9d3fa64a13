#include "workbench/study/summary_cells.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

namespace placedpar {

std::string ended_of(const StudyLine& line) {
    std::vector<std::string> parts;
    for (const auto& [ended, runs] : line.ended)
        parts.push_back(runs == line.runs ? ended : fmt::format("{} {}", runs, ended));
    std::string out = fmt::format("{}", fmt::join(parts, ", "));
    return line.refused.empty() ? out : out + ": " + line.refused;
}

std::string shown_mean(const StudyCell& cell) { return cell.runs == 0 ? "-" : fmt::format("{:.6g}", cell.mean); }

std::string shown_interval(const StudyCell& cell) {
    return cell.runs < 2 ? "" : fmt::format("± {:.2g}", cell.half_width);
}

std::string measure_with_unit(const StudySummary& summary, std::size_t measure) {
    const std::string &unit = summary.units[measure], &name = summary.measures[measure];
    const bool is_set_as_well = std::ranges::find(summary.axes, name) != summary.axes.end();
    return name + (is_set_as_well ? " measured" : "") + (unit.empty() ? "" : " [" + unit + "]");
}

} // namespace placedpar
