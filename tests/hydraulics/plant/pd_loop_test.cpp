#include "hydraulics/plant/pd_loop.hpp"

#include <boost/numeric/odeint.hpp>
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <initializer_list>

using namespace placedpar;
using namespace placedpar::hydraulics;

namespace {

using Complex = std::complex<double>;

bool near(Complex a, Complex b, double tolerance) { return std::abs(a - b) < tolerance; }

StepFigures step_figures(const PdLoop& loop) { return figures_of(step_response(loop, 0.001, 10001), 0.001); }

// A joint of the boom's size, with the reference loop's coefficients.
constexpr HydraulicJoint boom_joint{2.044e-11, 0.011746, 1.35e5, 0.011746, 6.13e-10};

} // namespace

TEST_CASE("the P-D loop has the known poles at the compliance of Figure 2.8") {
    PdLoop loop = reference_pd_loop();
    auto roots = poles(loop);
    CHECK(near(roots[0], {-17.937, 0}, 1e-3));
    CHECK(near(roots[1], {-6.0315, -6.8736}, 1e-4));
    CHECK(near(roots[2], {-6.0315, 6.8736}, 1e-4));
    CHECK(std::abs(oscillation(loop)->damping - 0.660) < 1e-3);
    CHECK(std::abs(oscillation(loop)->natural_rad_per_s - 9.145) < 1e-3);
    CHECK(stability_margin(loop) == doctest::Approx(6));
    StepFigures figures = step_figures(loop);
    CHECK(std::abs(figures.overshoot_percent - 5.2) < 0.05);
    CHECK(std::abs(figures.peak_time_s - 0.533) < 0.0011);
    CHECK(std::abs(figures.settling_time_s - 0.715) < 0.0011);
}

TEST_CASE("the limit of stability of the P-D loop is six times the compliance of Figure 2.8") {
    PdLoop limit = with_compliance(reference_pd_loop(), 6);
    auto roots = poles(limit);
    CHECK(near(roots[0], {-5, 0}, 1e-9));
    CHECK(near(roots[2], {0, std::sqrt(50)}, 1e-9));
    CHECK(stability_margin(limit) == doctest::Approx(1));

    PdLoop beyond = with_compliance(reference_pd_loop(), 7);
    CHECK(near(poles(beyond)[2], {0.234, 6.71}, 5e-3));
    CHECK(stability_margin(beyond) == doctest::Approx(6.0 / 7));
    CHECK(oscillation(beyond)->damping < 0);
}

TEST_CASE("Routh's criterion agrees with the poles, and the margin is proportional to 1 / C") {
    for (double a0 : {20.0, 100.0, 500.0})
        for (double a2 : {3.0, 30.0, 90.0})
            for (double factor : {0.3, 1.0, 2.0, 5.9, 6.1, 20.0}) {
                PdLoop nominal{a0, 100, a2, 15, 2}, loop = with_compliance(nominal, factor);
                CHECK((stability_margin(loop) > 1) == (poles(loop)[2].real() < 0 && poles(loop)[0].real() < 0));
                CHECK(stability_margin(loop) == doctest::Approx(stability_margin(nominal) / factor));
            }
}

TEST_CASE("poles are the roots of the denominator of 2.9") {
    for (double factor : {0.1, 1.0, 4.0, 9.0}) {
        PdLoop loop = with_compliance({120, 80, 45, 11, 3}, factor);
        Complex sum = 0;
        for (Complex s : poles(loop)) {
            Complex value = s * s * s + loop.a2_per_s * s * s + (loop.a1_per_s2 + loop.a0_per_s3 * loop.kv_s) * s +
                            loop.kp * loop.a0_per_s3;
            CHECK(std::abs(value) < 1e-8 * loop.kp * loop.a0_per_s3);
            sum += s;
        }
        CHECK(near(sum, -loop.a2_per_s, 1e-9 * loop.a2_per_s));
    }
    CHECK_FALSE(oscillation({1, 9, 6, 6, 2}).has_value()); // s^3 + 6 s^2 + 11 s + 6 has the roots -1, -2 and -3
}

TEST_CASE("with a_1 and a_2 as printed, a fourfold compliance changes little") {
    PdLoop printed = as_printed(reference_pd_loop());
    CHECK(std::abs(oscillation(printed)->damping - 0.280) < 1e-3);
    CHECK(std::abs(step_figures(printed).overshoot_percent - 39.9) < 0.1);
    PdLoop soft = with_compliance(printed, 4);
    CHECK(std::abs(oscillation(soft)->damping - 0.222) < 1e-3);
    CHECK(std::abs(step_figures(soft).overshoot_percent - 48) < 0.5);
}

TEST_CASE("a joint of the boom's size has the reference coefficients") {
    PdLoop loop = pd_loop_of(boom_joint, 15, 2);
    CHECK(loop.a0_per_s3 == doctest::Approx(100).epsilon(1e-3));
    CHECK(loop.a1_per_s2 == doctest::Approx(100).epsilon(1e-3));
    CHECK(loop.a2_per_s == doctest::Approx(30).epsilon(1e-3));
}

TEST_CASE("equation 2.9 with a_1 and a_2 exchanged follows from the equations of the joint") {
    // The equations are integrated directly, without the transfer function: theta, theta', load pressure.
    const HydraulicJoint& joint = boom_joint;
    constexpr double kp = 15, kv = 2, step_s = 0.01;
    using State = std::array<double, 3>;
    auto equations = [&](const State& s, State& rate, double) {
        double spool = kp * (1 - s[0]) - kv * s[1];
        rate[0] = s[1];
        rate[1] = joint.displacement_m3_per_rad * s[2] / joint.inertia_kg_m2;
        rate[2] = (2 * joint.flow_gain_m2_per_s * spool - joint.flow_pressure_m3_per_s_per_pa * s[2] -
                   2 * joint.displacement_m3_per_rad * s[1]) /
                  joint.compliance_m3_per_pa;
    };
    State state{0, 0, 0};
    boost::numeric::odeint::runge_kutta4<State> stepper;
    for (double response : step_response(pd_loop_of(joint, kp, kv), step_s, 200)) {
        CHECK(std::abs(state[0] - response) < 1e-6);
        for (int i = 0; i < 20; ++i)
            stepper.do_step(equations, state, 0, step_s / 20);
    }
}

TEST_CASE("a step response has the right overshoot, peak time and settling time") {
    StepFigures figures = figures_of({0, 0.5, 1.3, 0.9, 1.03, 0.99, 1.01}, 0.5);
    CHECK(figures.overshoot_percent == doctest::Approx(30));
    CHECK(figures.peak_time_s == doctest::Approx(1));
    CHECK(figures.settling_time_s == doctest::Approx(2.5));
    CHECK(figures_of({0, 0.5, 0.99, 0.995}, 1).overshoot_percent == 0);
}
