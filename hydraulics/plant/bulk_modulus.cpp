#include "hydraulics/plant/bulk_modulus.hpp"

#include <boost/math/tools/roots.hpp>

#include <cmath>
#include <cstdint>

namespace placedpar::hydraulics {

AirOilMixture air_oil_mixture(double air_fraction, double polytropic_exponent, const Parameters& parameters) {
    return {air_fraction, polytropic_exponent, parameters["oil.bulk_modulus"], parameters["oil.atmospheric_pressure"]};
}

double bulk_modulus_psi(const AirOilMixture& mixture, double psia) {
    double oil = 1 - mixture.air_fraction;
    double air = mixture.air_fraction * std::pow(mixture.atmospheric_psia / psia, 1 / mixture.polytropic_exponent);
    double softness_per_psi = oil / mixture.oil_modulus_psi + air / (mixture.polytropic_exponent * psia); // -dV/dP
    return (oil + air) / softness_per_psi;
}

double psia_at_modulus(const AirOilMixture& mixture, double share) {
    auto excess = [&](double psia) { return bulk_modulus_psi(mixture, psia) - share * mixture.oil_modulus_psi; };
    std::uintmax_t iterations = 200;
    auto [below, above] = boost::math::tools::bracket_and_solve_root(
        excess, mixture.atmospheric_psia, 2.0, true, boost::math::tools::eps_tolerance<double>(48), iterations);
    return (below + above) / 2;
}

} // namespace placedpar::hydraulics
