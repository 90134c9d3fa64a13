#include "hydraulics/circuit/boom_orifices.hpp"

namespace placedpar::hydraulics {

namespace {

double bypass_in2(double spool_in) {
    if (spool_in <= boom_dead_band_in)
        return -7.85 * spool_in + 1.5235; // A.3
    if (spool_in <= boom_bypass_shut_in)
        return -0.25 * (spool_in - 0.376); // A.4
    return 0;
}

double inlet_in2(double spool_in) {
    if (spool_in <= boom_dead_band_in)
        return 0;
    if (spool_in <= 0.376)
        return 1.247 * (spool_in - boom_dead_band_in); // A.5
    return 3.927 * (spool_in - 0.376) + 0.2346;        // A.6
}

double outlet_in2(double spool_in) {
    if (spool_in <= boom_dead_band_in)
        return 0;
    if (spool_in < boom_outlet_knee_in) // A.7; its slope .188 equals the dead band by coincidence
        return (spool_in - 0.248) * 0.188 + 0.0113;
    if (spool_in < 0.376)
        return (spool_in - 0.376) * 1.09 + 0.1509; // A.8
    return (spool_in - 0.376) * 3.927 + 0.1509;    // A.9
}

} // namespace

OrificeAreas boom_orifices(double spool_in) {
    return {inlet_in2(spool_in), bypass_in2(spool_in), outlet_in2(spool_in)};
}

int boom_orifice_branch(double spool_in) {
    return (spool_in > boom_dead_band_in) + (spool_in >= boom_outlet_knee_in) + (spool_in > boom_bypass_shut_in);
}

} // namespace placedpar::hydraulics
