#pragma once

namespace placedpar::hydraulics {

/// The open areas of the boom's part of the main valve, from which the flows are computed.
struct OrificeAreas {
    double inlet_in2;  ///< a_i, pump to the pressurised side of the cylinder
    double bypass_in2; ///< a_e, pump to tank
    double outlet_in2; ///< a_o, drain side of the cylinder to tank
};

/// Up to this spool position only the bypass is open (HminSpool[1] in the thesis).
inline constexpr double boom_dead_band_in = 0.188;
/// Above this spool position the area of the outlet grows faster with the position.
inline constexpr double boom_outlet_knee_in = 0.248;
/// From this spool position on the bypass is shut.
inline constexpr double boom_bypass_shut_in = 0.376;

/// Returns the areas at a spool position, by the functions A.3 to A.9 as the thesis prints them. Where two branches of
/// a function meet, their values differ by up to 7e-4 in^2, because the printed coefficients are rounded. The functions
/// hold only while the boom rises. REQUIRES: spool_in >= 0.
OrificeAreas boom_orifices(double spool_in);

/// Returns the number of knees, the three constants above, below the spool position. Between two knees the functions
/// are smooth, so that a solver can tell by this number whether its step crosses a knee.
int boom_orifice_branch(double spool_in);

} // namespace placedpar::hydraulics
