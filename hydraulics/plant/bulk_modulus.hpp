#pragma once

#include "hydraulics/data/parameters.hpp"

namespace placedpar::hydraulics {

/// Hydraulic oil with air bubbles, as in Figure 2.3 of the thesis. Air makes the oil softer, so a fault of the
/// simulated machine can be air in its oil. In this model the air never dissolves.
struct AirOilMixture {
    double air_fraction;        ///< x_0, share of the volume at atmospheric pressure
    double polytropic_exponent; ///< N: 1 isothermal, 1.4 adiabatic
    double oil_modulus_psi;     ///< B_0
    double atmospheric_psia;    ///< P_0
};

/// Returns a mixture with this fraction of air; the other constants are the parameters oil.bulk_modulus and
/// oil.atmospheric_pressure.
AirOilMixture air_oil_mixture(double air_fraction, double polytropic_exponent = 1,
                              const Parameters& parameters = Parameters::excavator());

/// Returns the bulk modulus of the mixture, beta = -V dP/dV, with V = V_oil + V_air (P_0 / P)^(1/N). dV/dP includes the
/// shrinking of the oil under pressure, but V does not. As the pressure grows, beta grows towards the oil's bulk
/// modulus. With more air, beta is smaller. REQUIRES: psia > 0, an absolute pressure; 0 <= air_fraction < 1.
double bulk_modulus_psi(const AirOilMixture& mixture, double psia);

/// Returns the absolute pressure at which the mixture's bulk modulus is `share` times the oil's. At lower pressures the
/// mixture is softer. REQUIRES: 0 < air_fraction < 1, 0 < share < 1.
double psia_at_modulus(const AirOilMixture& mixture, double share);

/// Returns the compliance of a fluid (2.2): the volume that it yields per psi of pressure, V / beta.
inline double fluid_compliance_in3_per_psi(double volume_in3, double modulus_psi) { return volume_in3 / modulus_psi; }

} // namespace placedpar::hydraulics
