#include "app/live_curve.hpp"

#include "text/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace placedpar {

namespace {

constexpr std::size_t label_columns = 12; ///< "  3996.92 | "

std::span<const LoggedGeneration> shown_of(const GenerationLog& log) {
    return log.compares() ? log.of_all() : log.of(0);
}

/// Selects at most one generation per column, evenly spread, including the last.
std::vector<LoggedGeneration> spread(std::span<const LoggedGeneration> generations, std::size_t columns) {
    std::size_t shown = std::min(generations.size(), columns);
    std::vector<LoggedGeneration> some;
    for (std::size_t column = 1; column <= shown; ++column)
        some.push_back(generations[column * generations.size() / shown - 1]);
    return some;
}

struct CurveAxis {
    double low, high;
    /// Returns the row of a value; row 0 is the highest of `rows` rows.
    std::size_t row(double value, std::size_t rows) const {
        double height = high > low ? std::clamp((value - low) / (high - low), 0.0, 1.0) : 0.5;
        return rows - 1 - static_cast<std::size_t>(std::lround(height * static_cast<double>(rows - 1)));
    }
};

CurveAxis axis_of(const std::vector<LoggedGeneration>& drawn, bool minimised) {
    std::vector<double> values;
    for (const LoggedGeneration& each : drawn) {
        if (std::isfinite(each.best))
            values.push_back(each.best);
        if (std::isfinite(each.mean))
            values.push_back(each.mean);
    }
    if (values.empty())
        return {0, 0};
    auto [least, greatest] = std::ranges::minmax(values);
    if (minimised)
        return {least, quantile(values, 0.9)};
    return {quantile(values, 0.1), greatest};
}

/// Draws '*' for the best and '.' for the mean.
std::vector<std::string> curve_rows(const std::vector<LoggedGeneration>& drawn, const CurveAxis& range,
                                    std::size_t rows) {
    std::vector<std::string> lines(rows, std::string(drawn.size(), ' '));
    for (std::size_t column = 0; column < drawn.size(); ++column) {
        lines[range.row(drawn[column].mean, rows)][column] = '.';
        lines[range.row(drawn[column].best, rows)][column] = '*';
    }
    return lines;
}

/// Draws a row of bars; the highest bar means a diversity of at least 1/2, which random strings have.
std::string diversity_row(const std::vector<LoggedGeneration>& drawn) {
    constexpr std::array<const char*, 9> bars{" ", "▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
    std::string row;
    for (const LoggedGeneration& each : drawn)
        row += bars[static_cast<std::size_t>(std::lround(std::clamp(16 * each.diversity, 0.0, 8.0)))];
    return row;
}

std::string labelled(const std::string& label, const std::string& row) {
    return fmt::format("{:>{}} |{}", label, label_columns - 2, row);
}

std::string axis_row(std::size_t columns, std::uint64_t first_generation, std::size_t generations) {
    const std::string first = fmt::format("{}", first_generation),
                      last = fmt::format("{}", first_generation + generations - 1);
    std::string axis(std::max(columns, first.size()), ' ');
    axis.replace(0, first.size(), first);
    if (columns > first.size() + last.size())
        axis.replace(columns - last.size(), last.size(), last);
    return std::string(label_columns, ' ') + axis;
}

} // namespace

std::string state_of(const GenerationLog& log) {
    auto generations = shown_of(log);
    if (generations.empty())
        return "";
    const LoggedGeneration& last = generations.back();
    std::string state = fmt::format("generation {}: best {:.6g}, mean {:.6g}, diversity {:.4f}",
                                    log.first() + generations.size() - 1, last.best, last.mean, last.diversity);
    return log.compares() ? fmt::format("{}, between {:.4f}", state, last.between) : state;
}

std::vector<std::string> live_curve(const GenerationLog& log, std::size_t columns, std::size_t rows) {
    std::vector<std::string> lines{state_of(log).substr(0, columns)};
    auto drawn = spread(shown_of(log), columns - label_columns);
    if (!drawn.empty()) {
        CurveAxis range = axis_of(drawn, log.minimises(0));
        auto curve = curve_rows(drawn, range, rows);
        for (std::size_t row = 0; row < rows; ++row) {
            bool end = row == 0 || row == rows - 1;
            double value = row == 0 ? range.high : range.low;
            lines.push_back(labelled(end ? fmt::format("{:.6g}", value) : "", curve[row]));
        }
        lines.push_back(labelled("diversity", diversity_row(drawn)));
        lines.push_back(axis_row(drawn.size(), log.first(), shown_of(log).size()));
    }
    lines.resize(rows + 3);
    return lines;
}

} // namespace placedpar
