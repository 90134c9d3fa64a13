#include "hydraulics/record_faults.hpp"

#include "hydraulics/record_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace placedpar {

namespace {

/// What the greatest value of a channel on an excavator is ordinarily between, in this room's unit.
struct Ordinary {
    double least, most;
};

std::optional<Ordinary> ordinary(Quantity quantity) {
    switch (quantity) {
    case Quantity::pressure: return Ordinary{60, 9000}; // the relief valve of such a machine opens at 4500 psi
    case Quantity::length: return Ordinary{0.05, 1.2};  // a spool's travel
    case Quantity::angle: return Ordinary{0, 400};
    case Quantity::voltage: return Ordinary{0, 15};
    case Quantity::area: return Ordinary{0, 3};
    default: return std::nullopt;
    }
}

bool same_text(const TextRow& a, const TextRow& b) {
    return std::ranges::equal(a.cells, b.cells, {}, &TextCell::text, &TextCell::text);
}

double median_step(std::span<const double> time_s) {
    std::vector<double> steps;
    for (std::size_t i = 1; i < time_s.size(); ++i)
        steps.push_back(time_s[i] - time_s[i - 1]);
    auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::ranges::nth_element(steps, middle);
    return *middle;
}

/// The fault between two neighbouring samples, if there is one.
std::optional<TextFault> fault_of_step(double step_s, double period_s, const TextRow& row, std::size_t line_before) {
    auto fault = [&](bool refused, std::string message, std::string hint) {
        return TextFault{refused, row.line, row.cells.front().column, std::move(message), std::move(hint)};
    };
    if (step_s == 0)
        return fault(true, fmt::format("the same time as on line {}, with other readings", line_before),
                     "leave out the one that is wrong");
    if (step_s < 0)
        return fault(true, fmt::format("{:.6g} s before the time on line {}", -step_s, line_before),
                     "rows must be in order of time");
    double periods = std::round(step_s / period_s);
    if (periods < 1 || std::abs(step_s - periods * period_s) > sampling_tolerance * period_s)
        return fault(true, fmt::format("{:.6g} s after the time on line {}", step_s, line_before),
                     fmt::format("a whole number of sampling periods of {:.6g} s (the median step), within {:.0f} %",
                                 period_s, 100 * sampling_tolerance));
    if (periods > 1)
        return fault(false, fmt::format("{:.0f} samples are missing before this one", periods - 1),
                     "no window and no slope reaches over the gap");
    return std::nullopt;
}

} // namespace

void drop_repeated_rows(TextTable& table, std::vector<TextFault>& faults) {
    std::vector<TextRow> kept;
    for (TextRow& row : table.rows) {
        if (!kept.empty() && same_text(kept.back(), row))
            faults.push_back({false, row.line, 1, fmt::format("repeats line {}", kept.back().line), "used once"});
        else
            kept.push_back(std::move(row));
    }
    table.rows = std::move(kept);
}

void check_times(Record& record, const TextTable& table, std::vector<TextFault>& faults) {
    if (record.size() < fewest_samples) {
        faults.push_back(
            {true, 0, 0, fmt::format("{} samples, expected at least {}", record.size(), fewest_samples), ""});
        return;
    }
    record.period_s = median_step(record.time_s);
    if (!(record.period_s > 0)) {
        faults.push_back({true, table.rows[1].line, 1, "most times do not rise", "rows must be in order of time"});
        return;
    }
    for (std::size_t i = 1; i < record.size(); ++i)
        if (auto fault = fault_of_step(record.time_s[i] - record.time_s[i - 1], record.period_s, table.rows[i],
                                       table.rows[i - 1].line))
            faults.push_back(std::move(*fault));
}

void check_channel(std::string_view name, const Unit& unit, std::span<const double> values, HeaderPlace place,
                   std::vector<TextFault>& faults) {
    auto warn = [&](std::string message, std::string hint) {
        faults.push_back({false, place.line, place.column, std::move(message), std::move(hint)});
    };
    auto [least, most] = std::ranges::minmax(values);
    if (least == most)
        warn(fmt::format("{} is {:.6g} {} in every sample", name, least / unit.factor, unit.name),
             "a sensor that is not connected, or a link that was not moved");
    auto usual = ordinary(unit.quantity);
    double greatest = std::max(std::abs(least), std::abs(most));
    if (!usual || greatest == 0 || (greatest >= usual->least && greatest <= usual->most))
        return;
    std::string likely;
    for (const Unit& other : units_of(unit.quantity))
        if (double meant = greatest / unit.factor * other.factor; meant >= usual->least && meant <= usual->most)
            likely += (likely.empty() ? "" : ", ") + std::string(other.name);
    warn(fmt::format("{} reaches {:.6g} {}, which is unusual", name, greatest / unit.factor, unit.name),
         likely.empty() ? "" : fmt::format("it would be ordinary in {}", likely));
}

} // namespace placedpar
