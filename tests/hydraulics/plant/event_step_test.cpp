#include "hydraulics/plant/event_step.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

using namespace placedpar;
using namespace placedpar::hydraulics;

namespace {

using State = std::vector<double>;

/// x' = x below 1 and 3 x above: the derivative jumps.
struct Jump {
    using Mode = bool;
    Mode rate(const State& x, State& slope, double) const {
        bool above = x[0] >= 1;
        slope[0] = above ? 3 * x[0] : x[0];
        return above;
    }
};

/// x' = |sin 10 t|: kinks in time.
struct Kinks {
    using Mode = bool;
    Mode rate(const State&, State& slope, double time_s) const {
        double sine = std::sin(10 * time_s);
        slope[0] = std::abs(sine);
        return sine >= 0;
    }
};

/// x' = -sign(x): x reaches 0 and stays there, with endless events.
struct Sliding {
    using Mode = bool;
    Mode rate(const State& x, State& slope, double) const {
        slope[0] = x[0] > 0 ? -1 : 1;
        return x[0] > 0;
    }
};

template <typename System>
double stepped(State start, double end_s, int steps) {
    System system;
    EventStepper stepper(system, std::move(start), 0);
    for (int i = 1; i <= steps; ++i)
        stepper.advance_to(end_s * i / steps, [](double, auto&, auto&) {});
    return stepper.state()[0];
}

/// Integrates with fixed steps, ignoring events.
template <typename System>
double plain(State state, double end_s, int steps) {
    System system;
    boost::numeric::odeint::runge_kutta4<State> stepper;
    auto rate = [&](const State& x, State& slope, double time_s) { system.rate(x, slope, time_s); };
    for (int i = 0; i < steps; ++i)
        stepper.do_step(rate, state, end_s * i / steps, end_s / steps);
    return state[0];
}

} // namespace

TEST_CASE("across a jump of the derivative the method keeps its order 4") {
    double exact = std::exp(3 * (1 - std::log(2.0))); // x begins at 1/2 and reaches 1 at ln 2
    double coarse = std::abs(stepped<Jump>({0.5}, 1, 10) - exact);
    double fine = std::abs(stepped<Jump>({0.5}, 1, 20) - exact);
    CHECK(coarse < 2e-4);
    CHECK(coarse / fine > 12); // 16 in theory, but the last steps before the event are cut short
    CHECK(std::abs(plain<Jump>({0.5}, 1, 20) - exact) > 500 * fine);
}

TEST_CASE("across kinks in time the method keeps its order 4") {
    double end_s = 1.9, exact = 6 * 0.2 + (1 - std::cos(10 * end_s - 6 * std::numbers::pi)) / 10;
    double coarse = std::abs(stepped<Kinks>({0}, end_s, 19) - exact);
    double fine = std::abs(stepped<Kinks>({0}, end_s, 38) - exact);
    CHECK(coarse < 1e-3);
    CHECK(coarse / fine > 12);
}

TEST_CASE("events are located and reported once, in order") {
    Jump system;
    EventStepper stepper(system, {0.5}, 0);
    std::vector<double> times;
    auto note = [&](double time_s, bool before, bool behind) {
        CHECK(!before);
        CHECK(behind);
        times.push_back(time_s);
    };
    for (int i = 1; i <= 100; ++i)
        stepper.advance_to(0.01 * i, note);
    REQUIRE(times.size() == 1);
    CHECK(std::abs(times[0] - std::log(2.0)) < 1e-9); // step .01: error of order 1e-10
}

TEST_CASE("the integration stops at each of several events within one step") {
    Kinks system;
    EventStepper stepper(system, {0}, 0);
    std::vector<double> times;
    stepper.advance_to(0.1, [](double, bool, bool) { FAIL("no event before .314 s"); });
    for (double end_s : {0.4, 0.8, 1.2}) // the first, second and third step each contain a kink
        stepper.advance_to(end_s, [&](double time_s, bool, bool) { times.push_back(time_s); });
    REQUIRE(times.size() == 3);
    for (std::size_t i = 0; i < 3; ++i)
        CHECK(std::abs(times[i] - std::numbers::pi / 10 * static_cast<double>(i + 1)) < 1e-11);
}

TEST_CASE("endless events cost few steps per call") {
    static std::size_t rates = 0;
    struct Counted : Sliding {
        Mode rate(const State& x, State& slope, double time_s) const {
            ++rates;
            return Sliding::rate(x, slope, time_s);
        }
    };
    CHECK(std::abs(stepped<Counted>({0.25}, 100, 10'000)) < 0.01);
    CHECK(rates < 10'000 * 60); // 5 evaluations per step, 50 per search for an event
}

TEST_CASE("time advances despite endless events") {
    Sliding system;
    EventStepper stepper(system, {0.25}, 0);
    for (int i = 1; i <= 100; ++i)
        stepper.advance_to(0.01 * i, [](double, bool, bool) {});
    CHECK(stepper.time_s() == doctest::Approx(1));
    CHECK(std::abs(stepper.state()[0]) < 0.01); // no farther from 0 than one step can reach
}
