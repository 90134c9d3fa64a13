#pragma once

#include "hydraulics/data/record.hpp"

#include <optional>

namespace placedpar::hydraulics {

/// How far a step of a logger's clock may be from whole periods, as a share of one; ours.
inline constexpr double jitter_tolerance = 0.25;

/// Puts readings whose instants jitter on whole periods, each on the line to its neighbour, so that slopes may be
/// taken over equal steps. The period becomes the mean one. Nothing is read from across a gap. Gives by how much the
/// worst instant was off, in s; nothing, and leaves the record as it is, where that is more than half a period, since
/// then the clock does not jitter, but runs at another rate in places. REQUIRES: at least two samples; every step is
/// within jitter_tolerance of whole periods, at least one.
std::optional<double> resample(Record& record);

} // namespace placedpar::hydraulics
