#pragma once

#include "hydraulics/data/record.hpp"

#include <span>

namespace placedpar::identification {

/// By how much a reading may lie off the median of the five around it, samples being 0.02 s apart; twice as far apart,
/// four times as much. Ours: twice what simulated machines reach at the high noise.
double greatest_excursion(hydraulics::Sensor sensor, double period_s);

/// Does the middle reading stand out from those around it, alone or with one beside it? No machine moves so: it is
/// the logger's or the line's. One that continues the two before or the two after is none, as where a log is spliced.
/// REQUIRES: five readings.
bool is_spike(std::span<const double> five, double greatest_excursion);

} // namespace placedpar::identification
