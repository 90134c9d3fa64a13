#include "hydraulics/data/sampling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace placedpar::hydraulics {

namespace {

/// The limits of the sampling period. At a longer period, five samples would take longer than a transient. Shorter
/// periods are untested.
constexpr double slowest_s = 0.1, quickest_s = 0.0001;
/// Rounding may put a period beyond these limits by this factor.
constexpr double rounding = 1 + 1e-6;

double mean_of(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

} // namespace

Sampling Sampling::of(double reading_s) {
    if (!(reading_s <= slowest_s * rounding))
        throw UnfitRecord(fmt::format("the readings are {:.4g} s apart, expected at most {:.4g} s: slower readings do "
                                      "not show a transient, which lasts some tenths of a second",
                                      reading_s, slowest_s));
    if (!(reading_s * rounding >= quickest_s))
        throw UnfitRecord(fmt::format("the readings are {:.4g} s apart, expected at least {:.4g} s (10 kHz): average "
                                      "them first, or check the time unit",
                                      reading_s, quickest_s));
    return {reading_s, std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(method_period_s / reading_s)))};
}

std::size_t Sampling::samples_in(double duration_s) const {
    return std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(duration_s / period_s())));
}

std::string rate_text(double period_s) {
    return period_s <= 0.001 ? fmt::format("{:.4g} kHz", 0.001 / period_s) : fmt::format("{:.4g} Hz", 1 / period_s);
}

std::string print_sampling(const Sampling& sampling) {
    return fmt::format("{} averaged to {}, {} readings each", rate_text(sampling.reading_s),
                       rate_text(sampling.period_s()), sampling.readings);
}

Record averaged(const Record& record, const Sampling& sampling) {
    Record samples;
    samples.description = record.description;
    samples.period_s = sampling.period_s();
    for (const Stretch& stretch : record.stretches())
        for (std::size_t first = stretch.first; first + sampling.readings <= stretch.last; first += sampling.readings) {
            samples.time_s.push_back(mean_of(std::span(record.time_s).subspan(first, sampling.readings)));
            if (!record.configuration.empty())
                samples.configuration += record.configuration[first + sampling.readings / 2];
            const std::size_t held = std::min(sampling.readings / 2, stretch.last - first - sampling.readings);
            for (Link link : all_links)
                for (Sensor sensor : all_sensors)
                    if (record.has(link, sensor))
                        samples.of(link, sensor)
                            .push_back(
                                mean_of(std::span(record.of(link, sensor))
                                            .subspan(first + (sensor == Sensor::servo ? held : 0), sampling.readings)));
        }
    return samples;
}

} // namespace placedpar::hydraulics
