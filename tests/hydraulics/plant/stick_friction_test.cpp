#include "hydraulics/plant/stick_friction.hpp"
#include "runtime/random.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace placedpar;
using namespace placedpar::hydraulics;

namespace {

constexpr StickFriction friction{6000, 7800, 0.3, 3e6, 5e4};

/// A mass of 1000 lbf s^2/in with friction, pushed by a constant force from rest.
struct Pushed {
    double position_in = 0, velocity_in_per_s = 0, bristle_in = 0;

    void push(double force_lbf, double duration_s) {
        constexpr double step_s = 2e-5, mass = 1000;
        for (double time_s = 0; time_s < duration_s; time_s += step_s) {
            double net = force_lbf - friction_force_lbf(friction, velocity_in_per_s, bristle_in);
            velocity_in_per_s += step_s * net / mass;
            bristle_in += step_s * bristle_rate_in_per_s(friction, velocity_in_per_s, bristle_in);
            position_in += step_s * velocity_in_per_s;
        }
    }
};

} // namespace

TEST_CASE("below the break-away force only the bristles move") {
    Pushed mass;
    for (double force = 0; force <= 7500; force += 100)
        mass.push(force, 0.1);
    mass.push(7500, 1);
    CHECK(mass.position_in < 0.0125); // the bristles deflect by .0025 in; the rest is creep under the jerks
    CHECK(mass.position_in > 7500 / 3e6 * 0.9);
    CHECK(std::abs(mass.velocity_in_per_s) < 1e-3);
    double held = mass.position_in;
    mass.push(7500, 5);
    CHECK(mass.position_in - held < 2e-3); // creep of the bristles, 4e-4 in/s at most
}

TEST_CASE("above the break-away force the mass slides against the Coulomb force") {
    Pushed mass;
    mass.push(8200, 1);
    CHECK(mass.position_in > 0.1);
    double before = mass.velocity_in_per_s;
    mass.push(8200, 1);
    CHECK(mass.velocity_in_per_s - before == doctest::Approx((8200 - 6000) / 1000.0).epsilon(1e-3));
}

TEST_CASE("the force of steady sliding agrees with the Stribeck curve") {
    CHECK(sliding_force_lbf(friction, 0) == 7800);
    CHECK(sliding_force_lbf(friction, 0.3) == doctest::Approx(6000 + 1800 * std::exp(-1)));
    CHECK(sliding_force_lbf(friction, 1.5) == doctest::Approx(6000).epsilon(1e-5));
    for (double velocity : {-2.0, -0.05, -0.001, 0.001, 0.03, 2.0}) { // in steady sliding the bristles do not move
        double bristle = std::copysign(sliding_force_lbf(friction, velocity) / 3e6, velocity);
        CHECK(std::abs(bristle_rate_in_per_s(friction, velocity, bristle)) < 1e-12);
        CHECK(friction_force_lbf(friction, velocity, bristle) ==
              doctest::Approx(std::copysign(sliding_force_lbf(friction, velocity), velocity)));
    }
}

TEST_CASE("friction returns at most the energy of its bristles") {
    RandomStream random(3, "friction");
    double bristle = 0, velocity = 0, work = 0, lowest = 0;
    for (int i = 0; i < 400000; ++i) {
        constexpr double step_s = 2e-5;
        velocity += step_s * 400 * (random.uniform() - 0.5) - 2e-4 * velocity;
        work += step_s * velocity * friction_force_lbf(friction, velocity, bristle);
        bristle += step_s * bristle_rate_in_per_s(friction, velocity, bristle);
        lowest = std::min(lowest, work);
        REQUIRE(std::abs(bristle) < 7800 / 3e6 * 1.001);
    }
    CHECK(lowest > -7800 * 7800 / 3e6 / 2 * 1.1);
    CHECK(work > 0);
}

TEST_CASE("friction constants of 0 give no friction") {
    StickFriction none{0, 0, 0.05, 3e6, 5e4};
    CHECK(friction_force_lbf(none, 1, 0) == 0);
    CHECK(bristle_rate_in_per_s(none, 1, 0) == 0);
}
