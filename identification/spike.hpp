#pragma once

#include "hydraulics/data/record.hpp"

#include <span>

namespace placedpar::identification {

/// Returns the largest accepted distance of a reading from the median of the five readings around it. Above a period of
/// 0.02 s, the limit grows with the square of the period. We chose these limits: twice the distances that simulated
/// machines reach at high noise.
double greatest_excursion(hydraulics::Sensor sensor, double period_s);

/// Returns whether the middle reading, alone or with one neighbour, stands out from the others. No machine moves like
/// that, so the logger or the signal line is at fault. A reading on the straight line through the two readings before
/// it, or the two after it, is accepted, since two logs may be joined there. REQUIRES: five readings.
bool is_spike(std::span<const double> five, double greatest_excursion);

} // namespace placedpar::identification
