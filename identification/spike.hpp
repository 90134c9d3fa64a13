#pragma once

#include "hydraulics/data/record.hpp"

#include <span>

namespace placedpar::identification {

/// Returns the largest accepted distance of a reading from the median of five readings, the reading itself in their
/// middle. If the sampling period is longer than 0.02 s, the limit grows with the square of the period. The limits are
/// twice the distances that simulated machines reach at high noise.
double greatest_excursion(hydraulics::Sensor sensor, double period_s);

/// Returns whether the middle reading, alone or with one neighbour, stands out from the others. No machine moves like
/// that, so the logger or the signal line is at fault. Two logs may be joined at the middle reading, which is then no
/// spike. Therefore a reading on the straight line through the two readings before it, or after it, is accepted.
/// REQUIRES: five readings.
bool is_spike(std::span<const double> five, double greatest_excursion);

} // namespace placedpar::identification
