#pragma once

#include "hydraulics/data/parameters.hpp"

namespace placedpar::hydraulics {

/// Hydraulic oil with free air, as in Figure 2.3 of the thesis. The air never dissolves.
struct AirOilMixture {
    double air_fraction;        ///< x_0, share of the volume at atmospheric pressure
    double polytropic_exponent; ///< N: 1 isothermal, 1.4 adiabatic
    double oil_modulus_psi;     ///< B_0
    double atmospheric_psia;    ///< P_0
};

/// Returns a mixture with this fraction of air, from the rows oil.bulk_modulus and oil.atmospheric_pressure.
AirOilMixture air_oil_mixture(double air_fraction, double polytropic_exponent = 1,
                              const Parameters& parameters = Parameters::excavator());

/// Returns beta = -V dP/dV of the mixture, from V = V_oil + V_air (P_0 / P)^(1/N). dV/dP includes the shrinking of the
/// oil under pressure; V does not. beta grows with pressure, falls with the air fraction, and tends to the oil's bulk
/// modulus. REQUIRES: psia > 0, an absolute pressure; 0 <= air_fraction < 1.
double bulk_modulus_psi(const AirOilMixture& mixture, double psia);

/// Returns the absolute pressure at which beta is `share` times the oil's bulk modulus; at lower pressures the mixture
/// is softer. REQUIRES: 0 < air_fraction < 1, 0 < share < 1.
double psia_at_modulus(const AirOilMixture& mixture, double share);

/// Returns the compliance of a fluid, C_fluid = V / beta (2.2).
inline double fluid_compliance_in3_per_psi(double volume_in3, double modulus_psi) { return volume_in3 / modulus_psi; }

} // namespace placedpar::hydraulics
