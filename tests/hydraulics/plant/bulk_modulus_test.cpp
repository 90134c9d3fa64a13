#include "hydraulics/plant/bulk_modulus.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>

using namespace placedpar;
using namespace placedpar::hydraulics;

namespace {

struct Known {
    double air_fraction, exponent, psia, modulus_kpsi;
};

// The values are computed independently, to the digits given.
constexpr Known known[] = {
    {.001, 1, 100, 166.2}, {.001, 1, 500, 217.2}, {.001, 1, 1000, 219.3},  {.001, 1, 2000, 219.8},
    {.01, 1, 100, 51.6},   {.01, 1, 500, 194.6},  {.01, 1, 1000, 213.1},   {.01, 1, 2000, 218.2},
    {.05, 1, 100, 12.3},   {.05, 1, 500, 131.1},  {.05, 1, 1000, 188.1},   {.05, 1, 2000, 211.1},
    {.05, 1.4, 100, 10.1}, {.05, 1.4, 500, 94.7}, {.05, 1.4, 1000, 156.9}, {.05, 1.4, 2000, 196.1},
    {.10, 1.4, 100, 5.0},  {.10, 1.4, 500, 58.2}, {.10, 1.4, 1000, 119.1}, {.10, 1.4, 2000, 175.0},
};

} // namespace

TEST_CASE("the bulk modulus of an air-oil mixture has the known values") {
    for (const Known& each : known) {
        CAPTURE(each.air_fraction);
        CAPTURE(each.psia);
        double modulus = bulk_modulus_psi(air_oil_mixture(each.air_fraction, each.exponent), each.psia);
        CHECK(std::abs(modulus / 1000 - each.modulus_kpsi) < 0.06);
    }
}

TEST_CASE("bulk modulus is -V dP/dV of a volume of oil and gas") {
    for (double exponent : {1.0, 1.4})
        for (double air : {0.0, 0.01, 0.1})
            for (double psia : {20.0, 200.0, 2000.0}) {
                AirOilMixture mixture = air_oil_mixture(air, exponent);
                auto volume = [&](double p) {
                    double shrunk = (p - 14.7) / 220e3; // the formula of V neglects this: 1 % at 2200 psi
                    return (1 - air) * (1 - shrunk) + air * std::pow(14.7 / p, 1 / exponent);
                };
                double step = psia * 1e-4;
                double slope = (volume(psia + step) - volume(psia - step)) / (2 * step);
                CHECK(bulk_modulus_psi(mixture, psia) == doctest::Approx(-volume(psia) / slope).epsilon(0.011));
            }
}

TEST_CASE("the bulk modulus tends to the oil's at high pressure and decreases with air") {
    CHECK(bulk_modulus_psi(air_oil_mixture(0), 100) == doctest::Approx(220e3));
    CHECK(bulk_modulus_psi(air_oil_mixture(0.05), 1e9) == doctest::Approx(220e3).epsilon(1e-4));
    for (double air : {0.001, 0.01, 0.05, 0.1, 0.5})
        for (double psia = 5; psia < 5000; psia *= 1.5) {
            CHECK(bulk_modulus_psi(air_oil_mixture(air), psia) < bulk_modulus_psi(air_oil_mixture(air), psia * 1.5));
            CHECK(bulk_modulus_psi(air_oil_mixture(air), psia) > bulk_modulus_psi(air_oil_mixture(air * 1.5), psia));
            CHECK(bulk_modulus_psi(air_oil_mixture(air), psia) < 220e3);
        }
}

TEST_CASE("air raises the compliance by an order of magnitude only below some hundred psia") {
    constexpr double air[] = {.01, .02, .05, .10}, tenth[] = {60, 85, 137, 199}, half[] = {181, 257, 412, 598};
    for (int i = 0; i < 4; ++i) {
        CAPTURE(air[i]);
        CHECK(std::abs(psia_at_modulus(air_oil_mixture(air[i]), 0.1) - tenth[i]) < 0.6);
        CHECK(std::abs(psia_at_modulus(air_oil_mixture(air[i]), 0.5) - half[i]) < 0.6);
    }
    for (double share : {0.001, 0.3, 0.999})
        CHECK(bulk_modulus_psi(air_oil_mixture(0.03, 1.4), psia_at_modulus(air_oil_mixture(0.03, 1.4), share)) ==
              doctest::Approx(share * 220e3));
}

TEST_CASE("the boom's compliance of .0086 in^3/psi is that of 1892 in^3 of oil") {
    CHECK(std::abs(fluid_compliance_in3_per_psi(1892, bulk_modulus_psi(air_oil_mixture(0), 1800)) - 0.0086) < 1e-6);
}
