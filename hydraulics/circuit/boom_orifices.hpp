#pragma once

namespace placedpar::hydraulics {

/// The open areas of the boom's main valve.
struct OrificeAreas {
    double inlet_in2;  ///< a_i, pump to the pressurised side of the cylinder
    double bypass_in2; ///< a_e, pump to tank
    double outlet_in2; ///< a_o, drain side of the cylinder to tank
};

/// Up to this position only the bypass is open (HminSpool[1] in the thesis).
inline constexpr double boom_dead_band_in = 0.188;
/// From this position on the outlet opens more steeply.
inline constexpr double boom_outlet_knee_in = 0.248;
/// From this position on the bypass is shut.
inline constexpr double boom_bypass_shut_in = 0.376;

/// Returns the areas by the spool-orifice functions A.3 to A.9 as printed. Where two branches of a function meet, their
/// values differ by up to 7e-4 in^2, because the printed coefficients are rounded. The functions hold for raising only.
/// REQUIRES: spool_in >= 0.
OrificeAreas boom_orifices(double spool_in);

/// Returns the number of knees below the spool position. Within each interval between knees the functions are smooth.
int boom_orifice_branch(double spool_in);

} // namespace placedpar::hydraulics
