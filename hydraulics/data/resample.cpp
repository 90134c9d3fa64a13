#include "hydraulics/data/resample.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

namespace placedpar::hydraulics {

namespace {

/// Returns, for each sample, the number of whole periods since the first.
std::vector<double> whole_periods(const Record& record) {
    std::vector<double> periods{0};
    for (std::size_t i = 1; i < record.size(); ++i)
        periods.push_back(periods.back() + std::round((record.time_s[i] - record.time_s[i - 1]) / record.period_s));
    return periods;
}

/// Returns the neighbour of sample i for the interpolation at the given time, or i itself if gaps are on both sides.
std::size_t neighbour(std::size_t i, double time_s, std::span<const double> times_s, std::span<const double> periods) {
    bool before = i > 0 && periods[i] - periods[i - 1] == 1;
    bool after = i + 1 < periods.size() && periods[i + 1] - periods[i] == 1;
    if (after && (time_s >= times_s[i] || !before))
        return i + 1;
    return before ? i - 1 : i;
}

} // namespace

std::optional<double> resample(Record& record) {
    std::vector<double> periods = whole_periods(record), times_s = record.time_s, regular_s, before;
    double period_s = (times_s.back() - times_s.front()) / periods.back(), start_s = 0, worst_s = 0;
    for (std::size_t i = 0; i < times_s.size(); ++i)
        start_s += (times_s[i] - periods[i] * period_s) / static_cast<double>(times_s.size());
    for (std::size_t i = 0; i < times_s.size(); ++i) {
        regular_s.push_back(start_s + periods[i] * period_s);
        worst_s = std::max(worst_s, std::abs(times_s[i] - regular_s[i]));
    }
    if (worst_s > period_s / 2)
        return std::nullopt;
    record.period_s = period_s;
    record.time_s = std::move(regular_s);
    for (Link link : all_links)
        for (Sensor sensor : all_sensors) {
            std::vector<double>& values = record.of(link, sensor);
            before = values;
            for (std::size_t i = 0; i < values.size(); ++i)
                if (std::size_t other = neighbour(i, record.time_s[i], times_s, periods); other != i)
                    values[i] = before[i] + (before[other] - before[i]) * (record.time_s[i] - times_s[i]) /
                                                (times_s[other] - times_s[i]);
        }
    return worst_s;
}

} // namespace placedpar::hydraulics
