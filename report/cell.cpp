#include "report/cell.hpp"

#include <array>
#include <cmath>
#include <utility>

namespace placedpar {

const char* name_of(Origin origin) {
    constexpr std::array names{"outcome", "calibrated", "workload", "fitted", "constant"};
    return names[static_cast<std::size_t>(origin)];
}

const char* name_of(Judge judge) {
    constexpr std::array names{"thesis", "published", "own"};
    return names[static_cast<std::size_t>(judge)];
}

std::optional<double> Cell::error_percent() const {
    if (!reference || std::isnan(simulated) || (*reference == 0 && simulated != 0))
        return std::nullopt;
    return *reference == 0 ? 0 : 100 * (simulated - *reference) / std::abs(*reference);
}

std::optional<double> Cell::tolerance_in_percent() const {
    if (!tolerance)
        return tolerance_percent;
    return reference && *reference != 0 ? std::optional(100 * *tolerance / std::abs(*reference)) : std::nullopt;
}

bool Cell::within_tolerance() const {
    if (at_least || at_most) {
        const auto [low, high] = interval.value_or(Interval{simulated, simulated});
        return high >= at_least.value_or(high) && low <= at_most.value_or(low);
    }
    if (tolerance)
        return reference && std::abs(simulated - *reference) <= *tolerance;
    if (!tolerance_percent)
        return true;
    auto error = error_percent();
    return error && std::abs(*error) <= *tolerance_percent;
}

Cell cell_of(std::string row, std::string column, std::string unit, std::optional<double> known, double value,
             std::optional<double> tolerance, int decimals) {
    return {.row = std::move(row),
            .column = std::move(column),
            .unit = std::move(unit),
            .reference = known,
            .simulated = value,
            .tolerance = known ? tolerance : std::nullopt,
            .decimals = decimals};
}

Cell plain_cell(std::string row, std::string column, std::string unit, double value, int decimals) {
    return cell_of(std::move(row), std::move(column), std::move(unit), {}, value, {}, decimals);
}

Cell compared_cell(std::string row, std::string column, std::string unit, double known, double value, int decimals) {
    return cell_of(std::move(row), std::move(column), std::move(unit), known, value, {}, decimals);
}

Cell judged_cell(std::string row, std::string column, std::string unit, double known, double value, double tolerance,
                 int decimals) {
    return cell_of(std::move(row), std::move(column), std::move(unit), known, value, tolerance, decimals);
}

Cell at_least(double bound, Cell cell) {
    cell.at_least = bound;
    return cell;
}

Cell at_most(double bound, Cell cell) {
    cell.at_most = bound;
    return cell;
}

Cell share_cell(std::string row, std::string column, std::size_t successes, std::size_t runs) {
    const double percent = runs == 0 ? 0 : 100 * static_cast<double>(successes) / static_cast<double>(runs);
    Cell cell = plain_cell(std::move(row), std::move(column), "%", percent, 1);
    cell.interval = runs == 0 ? Interval{0, 100} : success_interval(successes, runs);
    return cell;
}

Cell judged_by(Judge judge, Cell cell) {
    cell.judge = judge;
    return cell;
}

double share_tolerance(double known_percent, std::size_t records) {
    auto n = static_cast<double>(records);
    double share = (0.01 * known_percent * n + 2) / (n + 4);
    return 100 * deviations_allowed * std::sqrt(2 * share * (1 - share) / n);
}

double deviation_tolerance(double known, std::size_t records, double rounding) {
    return deviations_allowed * known / std::sqrt(static_cast<double>(records - 1)) + rounding;
}

double mean_tolerance(double deviation, std::size_t records, double bias) {
    return deviations_allowed * deviation / std::sqrt(static_cast<double>(records)) + bias;
}

} // namespace placedpar
