#pragma once

namespace placedpar::hydraulics {

/// Open areas of the boom main valve.
struct OrificeAreas {
    double inlet_in2;  ///< a_i, pump to the pressurised side of the cylinder
    double bypass_in2; ///< a_e, pump to tank
    double outlet_in2; ///< a_o, drain side of the cylinder to tank
};

/// HminSpool[1]: up to here only the bypass is open.
inline constexpr double boom_dead_band_in = 0.188;
/// From here the outlet opens more steeply.
inline constexpr double boom_outlet_knee_in = 0.248;
/// From here the bypass is shut.
inline constexpr double boom_bypass_shut_in = 0.376;

/// The spool-orifice functions A.3 to A.9, as printed; where two branches meet they leave steps of up to
/// 7e-4 in^2, the rounding of the print. Raising direction only. REQUIRES: spool_in >= 0.
OrificeAreas boom_orifices(double spool_in);

/// Between which of their knees the spool stands; the functions are smooth where this stays the same.
int boom_orifice_branch(double spool_in);

} // namespace placedpar::hydraulics
