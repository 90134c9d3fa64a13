#pragma once

#include "hydraulics/data/record.hpp"

#include <optional>

namespace placedpar::hydraulics {

/// The largest deviation of a logger's step from whole periods, as a share of a period; our choice.
inline constexpr double jitter_tolerance = 0.25;

/// Resamples readings whose instants jitter. Linear interpolation between neighbours gives readings that are whole
/// periods apart, so that slopes can use equal steps. The period becomes the mean period. Nothing is interpolated
/// across a gap. Returns the largest distance, in s, of an instant from its regular time. If this distance exceeds half
/// a period, the clock does not jitter but changes its rate: the function then returns nullopt and leaves the record
/// unchanged. REQUIRES: at least two samples; every step is at least one period and within jitter_tolerance of whole
/// periods.
std::optional<double> resample(Record& record);

} // namespace placedpar::hydraulics
