#include "hydraulics/data/record_faults.hpp"

#include "hydraulics/data/frozen_run.hpp"
#include "hydraulics/data/resample.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace placedpar::hydraulics {

namespace {

/// The usual range of a channel's greatest value on an excavator, in the unit of units.hpp.
struct Ordinary {
    double least, most;
};

constexpr Ordinary ordinary_period_s{0.0005, 1};

Ordinary ordinary(Sensor sensor) {
    switch (sensor) {
    case Sensor::inlet_pressure: return {300, 9000}; // the relief valve of such a machine opens at 4500 psi
    case Sensor::outlet_pressure: return {5, 9000};
    case Sensor::angle: return {0, 400};
    case Sensor::spool: return {0.05, 1.2};
    case Sensor::servo: return {0, 15};
    case Sensor::inlet_area:
    case Sensor::bypass_area: return {0, 3};
    }
    return {0, std::numeric_limits<double>::infinity()};
}

bool within(double value, const Ordinary& usual) { return value >= usual.least && value <= usual.most; }

/// Returns the units in which the number in the text would have a usual size.
std::string likely_units(Quantity quantity, double number, const Ordinary& usual) {
    std::string likely;
    for (const Unit& unit : units_of(quantity))
        if (within(number * unit.factor, usual))
            likely += (likely.empty() ? "the value would be usual in " : ", ") + std::string(unit.name);
    return likely;
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

/// Returns the fault in the time step between two neighbouring samples, if there is one.
std::optional<Diagnostic> fault_of_step(double step_s, double period_s, const TextCell& time, std::size_t line,
                                        std::size_t line_before) {
    if (step_s == 0)
        return error_at(line, time.column,
                        fmt::format("the time is the same as on line {}, but the readings differ", line_before),
                        "leave out the row that is wrong");
    if (step_s < 0)
        return error_at(line, time.column,
                        fmt::format("the time is {:.6g} s before the time on line {}", -step_s, line_before),
                        "rows must be in order of time");
    double periods = std::round(step_s / period_s);
    if (periods < 1 || std::abs(step_s - periods * period_s) > jitter_tolerance * period_s)
        return error_at(
            line, time.column, fmt::format("the time is {:.6g} s after the time on line {}", step_s, line_before),
            fmt::format(
                "steps must be whole numbers of sampling periods of {:.6g} s (the median step), within {:.0f} %",
                period_s, 100 * jitter_tolerance));
    if (periods > 1)
        return warning_at(
            line, time.column,
            fmt::format("{:.0f} sample{} missing before this one", periods - 1, periods == 2 ? " is" : "s are"),
            "windows and slopes do not extend across the gap");
    return std::nullopt;
}

/// Returns whether a step deviates from whole periods by more than sampling_tolerance.
bool jitters(const Record& record) {
    for (std::size_t i = 1; i < record.size(); ++i) {
        double periods = (record.time_s[i] - record.time_s[i - 1]) / record.period_s;
        if (std::abs(periods - std::round(periods)) > sampling_tolerance)
            return true;
    }
    return false;
}

} // namespace

void drop_repeated_rows(TextTable& table, const std::optional<RowBefore>& before, std::vector<Diagnostic>& faults) {
    std::vector<TextRow> kept;
    for (TextRow& row : table.rows) {
        const TextRow* last = !kept.empty() ? &kept.back() : before ? &before->row : nullptr;
        if (last && same_text(*last, row))
            faults.push_back(
                warning_at(row.line, 1, fmt::format("the row repeats line {}", last->line), "the row is used once"));
        else
            kept.push_back(std::move(row));
    }
    table.rows = std::move(kept);
}

void check_times(Record& record, const TextTable& table, const TimeColumn& time, const std::optional<RowBefore>& before,
                 std::vector<Diagnostic>& faults) {
    const bool goes_on = record.period_s > 0;
    record.period_s = goes_on ? record.period_s : median_step(record.time_s);
    if (!(record.period_s > 0)) {
        faults.push_back(error_at(table.rows[1].line, table.rows[1].cells[time.index].column, "most times do not rise",
                                  "rows must be in order of time"));
        return;
    }
    for (std::size_t i = before ? 0 : 1; i < record.size(); ++i) {
        const double since_s = record.time_s[i] - (i == 0 ? before->time_s : record.time_s[i - 1]);
        if (auto fault = fault_of_step(since_s, record.period_s, table.rows[i].cells[time.index], table.rows[i].line,
                                       i == 0 ? before->row.line : table.rows[i - 1].line))
            faults.push_back(std::move(*fault));
    }
    if (!has_errors(faults) && jitters(record)) {
        if (auto worst_s = resample(record))
            faults.push_back(
                warning_at(time.place.line, time.place.column,
                           fmt::format("the times differ by up to {:.3g} {} from whole periods of {:.4g} {}",
                                       *worst_s / time.unit.factor, time.unit.name, record.period_s / time.unit.factor,
                                       time.unit.name),
                           "readings at whole periods are interpolated linearly between neighbouring samples"));
        else
            faults.push_back(
                error_at(time.place.line, time.place.column,
                         "the sampling period changes: the times differ from whole periods by more than half a period",
                         "write a separate record for each sampling rate"));
    }
    if (double number = record.period_s / time.unit.factor; !goes_on && !within(record.period_s, ordinary_period_s))
        faults.push_back(
            warning_at(time.place.line, time.place.column,
                       fmt::format("samples are {:.6g} {} apart, which is unusual", number, time.unit.name),
                       likely_units(Quantity::time, number, ordinary_period_s)));
}

void check_channel(std::string_view name, Sensor sensor, const Unit& unit, double least, double most, HeaderPlace place,
                   std::vector<Diagnostic>& faults) {
    auto warn = [&](std::string message, std::string hint) {
        faults.push_back(warning_at(place.line, place.column, std::move(message), std::move(hint)));
    };
    if (least == most)
        warn(fmt::format("{} is {:.6g} {} in every sample", name, least / unit.factor, unit.name),
             "the sensor may not be connected, or the link was not moved");
    double greatest = std::max(std::abs(least), std::abs(most)), number = greatest / unit.factor;
    Ordinary usual = ordinary(sensor);
    if (greatest > 0 && !within(greatest, usual))
        warn(fmt::format("{} reaches {:.6g} {}, which is unusual", name, number, unit.name),
             likely_units(unit.quantity, number, usual));
}

void check_pressure(std::string_view name, const Unit& unit, std::span<const double> psi, const TextTable& table,
                    std::size_t index, std::vector<Diagnostic>& faults) {
    auto below = [](double each) { return each < vacuum_psi; };
    const auto first = std::ranges::find_if(psi, below);
    if (first == psi.end())
        return;
    const TextRow& row = table.rows[static_cast<std::size_t>(first - psi.begin())];
    faults.push_back(
        warning_at(row.line, row.cells[index].column,
                   fmt::format("{} is {:.6g} {}, below vacuum ({} of {} samples)", name, *first / unit.factor,
                               unit.name, std::ranges::count_if(psi, below), psi.size()),
                   "no pressure is below vacuum: check the sign of the sensor's readings"));
}

void check_frozen(std::string_view name, const Unit& unit, std::span<const double> readings, double least_jump,
                  double period_s, const TextTable& table, std::size_t index, std::vector<Diagnostic>& faults) {
    const auto frozen = frozen_run(readings, least_jump, fewest_frozen(period_s));
    if (!frozen)
        return;
    const TextRow& row = table.rows[frozen->first];
    faults.push_back(warning_at(row.line, row.cells[index].column,
                                fmt::format("{} stays at {:.6g} {} up to line {}, and then jumps by {:.4g} {}", name,
                                            readings[frozen->first] / unit.factor, unit.name,
                                            table.rows[frozen->last - 1].line, frozen->jump / unit.factor, unit.name),
                                "the sensor or the logger may have stopped for a time: leave these rows out"));
}

} // namespace placedpar::hydraulics
