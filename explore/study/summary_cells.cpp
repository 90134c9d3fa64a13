#include "explore/study/summary_cells.hpp"

#include "text/counted.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

namespace placedpar {

std::string shown_settings(const Overrides& set) {
    std::vector<std::string> parts;
    for (const auto& [name, value] : set)
        parts.push_back(fmt::format("{} = {}", name, value));
    return fmt::format("{}", fmt::join(parts, ", "));
}

std::string there_is_no_reference(const Overrides& wanted, const std::vector<std::string>& set) {
    return fmt::format("no combination has {}, so figures cannot be relative to it; {}", shown_settings(wanted),
                       set.empty() ? "the runs have no settings"
                                   : fmt::format("the runs set {}", fmt::join(set, ", ")));
}

bool has_intervals(const StudySummary& summary) {
    return std::ranges::any_of(summary.lines, [](const StudyLine& line) { return line.runs > 1; });
}

std::string ended_of(const StudyLine& line) {
    std::vector<std::string> parts;
    for (const auto& [ended, runs] : line.ended)
        parts.push_back(runs == line.runs ? ended : fmt::format("{} {}", runs, ended));
    for (const auto& [measure, runs] : line.without)
        parts.push_back(fmt::format("{} without {}", runs, measure));
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
    return (summary.relative_to.empty() ? "" : "relative ") + name + (is_set_as_well ? " measured" : "") +
           (unit.empty() ? "" : " [" + unit + "]");
}

std::string shown_value(const StudyLine& line, std::size_t axis) {
    return line.values[axis].empty() ? "not set" : line.values[axis];
}

std::string shown_setting(const StudySummary& summary, const StudyLine& line, std::size_t axis) {
    return summary.axes[axis] + (line.values[axis].empty() ? " " : " = ") + shown_value(line, axis);
}

std::vector<std::string> said_of_all(const StudySummary& summary) {
    std::vector<std::string> said;
    if (!summary.fixed.empty())
        said.push_back("all with " + shown_settings(summary.fixed));
    if (!summary.relative_to.empty())
        said.push_back("relative to " + shown_settings(summary.relative_to));
    if (summary.unrelated > 0)
        said.push_back(fmt::format(
            "no relative figures for {}: no run with the settings above and the same seed ended in the same way",
            counted(summary.unrelated, "run")));
    return said;
}

} // namespace placedpar
