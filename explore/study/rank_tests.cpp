// Prints rank tests of a study's settings.

#include "explore/study/study_report.hpp"
#include "explore/study/summary_cells.hpp"
#include "report/field.hpp"
#include "text/rank_test.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace placedpar {

namespace {

/// Combinations that differ in one setting only.
struct Compared {
    std::string others; ///< the other settings that vary, such as "links = 2"
    std::vector<const StudyLine*> lines;
};

std::vector<Compared> compared_along(const StudySummary& summary, std::size_t axis) {
    std::map<std::vector<std::string>, Compared> all; // key: values of the other settings
    for (const StudyLine& line : summary.lines) {
        std::vector<std::string> others = line.values, shown;
        others[axis].clear();
        for (std::size_t i = 0; i < others.size(); ++i)
            if (i != axis)
                shown.push_back(shown_setting(summary, line, i));
        Compared& compared = all[others];
        compared.others = fmt::format("{}", fmt::join(shown, ", "));
        compared.lines.push_back(&line);
    }
    std::vector<Compared> list;
    for (const auto& each : all)
        list.push_back(each.second);
    return list;
}

std::vector<double> figures_of_runs(const StudyLine& line, std::size_t measure) {
    std::vector<double> figures;
    for (const StudiedRun& run : line.each)
        if (run.figures[measure])
            figures.push_back(*run.figures[measure]);
    return figures;
}

/// Returns the test. Returns nothing if fewer than two combinations have several figures, or if in each combination all
/// figures are equal, because seeds then make no difference.
std::optional<RankTest> test_of(const std::vector<std::vector<double>>& groups) {
    const bool varies = std::ranges::any_of(
        groups, [](const auto& group) { return std::ranges::min(group) != std::ranges::max(group); });
    if (groups.size() < 2 || !varies)
        return std::nullopt;
    return groups.size() == 2 ? mann_whitney(groups[0], groups[1]) : kruskal_wallis(groups);
}

/// Returns the table row with the test of a measure. Returns nothing if there is no test. The test compares the
/// combinations that have several figures of the measure.
std::optional<Row> tested(const StudySummary& summary, std::size_t axis, const Compared& compared,
                          std::size_t measure) {
    std::vector<std::vector<double>> groups;
    std::vector<std::string> values;
    for (const StudyLine* line : compared.lines)
        if (std::vector<double> figures = figures_of_runs(*line, measure); figures.size() > 1) {
            groups.push_back(std::move(figures));
            values.push_back(shown_value(*line, axis));
        }
    const std::optional<RankTest> test = test_of(groups);
    if (!test)
        return std::nullopt;
    const bool two = groups.size() == 2;
    return Row{Field::left(0, "setting", summary.axes[axis]),
               Field::left(0, "of",
                           two ? fmt::format("{}", fmt::join(values, ", ")) : fmt::format("{} values", groups.size())),
               Field::left(0, "with", compared.others).shown_if(summary.axes.size() > 1),
               Field::left(0, "measure", measure_with_unit(summary, measure)),
               Field::right(0, "p", test->p < 1e-4 ? "< 0.0001" : fmt::format("{:.4f}", test->p)),
               Field::left(0, "effect", fmt::format("{} {:.2f}", two ? "A" : "epsilon²", test->effect)),
               Field::left(0, "test", two ? "Mann-Whitney" : "Kruskal-Wallis")};
}

} // namespace

std::string print_rank_tests(const StudySummary& summary) {
    std::vector<Row> rows;
    for (std::size_t axis = 0; axis < summary.axes.size(); ++axis)
        for (const Compared& compared : compared_along(summary, axis))
            for (std::size_t measure = 0; measure < summary.measures.size(); ++measure)
                if (auto row = tested(summary, axis, compared, measure))
                    rows.push_back(std::move(*row));
    return rows.empty() ? "" : "\nRank tests\n" + Table{rows.front(), rows}.text();
}

} // namespace placedpar
