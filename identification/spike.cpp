#include "identification/spike.hpp"

#include "text/statistics.hpp"

#include <algorithm>
#include <cmath>

namespace placedpar::identification {

using hydraulics::Sensor;

namespace {

double excursion_at_usual_period(Sensor sensor) {
    switch (sensor) {
    case Sensor::inlet_pressure:
    case Sensor::outlet_pressure: return 80; // psi
    case Sensor::angle: return 0.08;         // deg
    case Sensor::spool: return 0.008;        // in
    case Sensor::servo: return 0.1;          // V
    case Sensor::inlet_area: return 0.03;    // in^2; by A.6 the area changes by this over .008 in of spool
    case Sensor::bypass_area: break;
    }
    return 0.063; // in^2; by A.3 the area changes by this over .008 in of spool
}

} // namespace

double greatest_excursion(Sensor sensor, double period_s) {
    constexpr double usual_period_s = 0.02;
    const double apart = std::max(period_s / usual_period_s, 1.0);
    return excursion_at_usual_period(sensor) * apart * apart;
}

bool is_spike(std::span<const double> five, double greatest) {
    auto far_from = [&](double expected) { return std::abs(five[2] - expected) > greatest; };
    return far_from(median({five.begin(), five.end()})) && far_from(2 * five[1] - five[0]) &&
           far_from(2 * five[3] - five[4]);
}

} // namespace placedpar::identification
