#include "experiments/kit/cells.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace placedpar {

Cell plain_cell(std::string row, std::string column, std::string unit, double value, int decimals) {
    Cell cell{std::move(row), std::move(column), std::move(unit), {}, value, {}};
    cell.decimals = decimals;
    return cell;
}

Cell compared_cell(std::string row, std::string column, std::string unit, double known, double value, int decimals) {
    Cell cell = plain_cell(std::move(row), std::move(column), std::move(unit), value, decimals);
    cell.thesis = known;
    return cell;
}

Cell judged_cell(std::string row, std::string column, std::string unit, double known, double value, double tolerance,
                 int decimals) {
    Cell cell = compared_cell(std::move(row), std::move(column), std::move(unit), known, value, decimals);
    cell.tolerance = tolerance;
    return cell;
}

Cell at_least(double bound, Cell cell) {
    cell.at_least = bound;
    return cell;
}

Cell at_most(double bound, Cell cell) {
    cell.at_most = bound;
    return cell;
}

double mean(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double deviation(const std::vector<double>& values) {
    double centre = mean(values), squares = 0;
    for (double value : values)
        squares += (value - centre) * (value - centre);
    return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

double share_tolerance(double known_percent, std::size_t records) {
    auto n = static_cast<double>(records);
    double share = (0.01 * known_percent * n + 2) / (n + 4);
    return 300 * std::sqrt(2 * share * (1 - share) / n);
}

double deviation_tolerance(double known, std::size_t records, double rounding) {
    return 3 * known / std::sqrt(static_cast<double>(records - 1)) + rounding;
}

double percent_within(const std::vector<double>& values, double limit) {
    auto within = std::ranges::count_if(values, [&](double value) { return value <= limit; });
    return 100 * static_cast<double>(within) / static_cast<double>(values.size());
}

} // namespace placedpar
