#pragma once

#include "hydraulics/data/record.hpp"

#include <optional>

namespace placedpar::hydraulics {

/// The largest accepted deviation of a logger's step from a whole number of periods, as a share of a period; this
/// project's choice.
inline constexpr double jitter_tolerance = 0.25;

/// Replaces readings at irregular instants by readings at regular instants, since slopes need equal steps of time. The
/// new readings are interpolated linearly between neighbours, but not across a gap. The record's period becomes the
/// mean period. Returns the largest distance, in s, of an old instant from its regular instant. A distance above half a
/// period means that the clock changes its rate; the function then returns nullopt and leaves the record unchanged.
/// REQUIRES: at least two samples; every step is at least one period and within jitter_tolerance of whole periods.
std::optional<double> resample(Record& record);

} // namespace placedpar::hydraulics
