#include "identification/on_line/set_watch.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstddef>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;

namespace {

/// A watch of the boom alone, fed with samples made by the test.
class WatchedBoom {
public:
    void feed(std::size_t samples, double inlet_in2, double flow_in3_per_s, double psi = 1500) {
        constexpr std::array valves{AreasFrom::spool};
        for (std::size_t i = 0; i < samples; ++i) {
            const double swing = std::sin(static_cast<double>(++taken_)); // keeps readings from looking frozen
            const SetSample sample{{psi + 100 * swing, 100 * swing, flow_in3_per_s, inlet_in2, 0.03}};
            noted += watch.note_moving_shut(problem, sample, health);
            judged += watch.take(problem, sample, valves, health).has_value();
        }
    }
    SetProblem problem{Configuration::a, {Link::boom}, fitted_flow_constants(), 10};
    SetWatch watch{Sampling{0.02, 1}, SetWatch::first_state({Link::boom})};
    std::array<double, 1> health{0.0086};
    int noted = 0, judged = 0;

private:
    std::size_t taken_ = 0;
};

} // namespace

TEST_CASE("a piston driven after a movement by a valve that reads shut is a sensor fault") {
    WatchedBoom boom;
    boom.feed(20, 0, 0);
    boom.feed(30, 0.09, 30);
    boom.feed(24, 0, 30);
    CHECK(boom.judged == 1);
    CHECK(boom.noted == 0);
    CHECK_FALSE(boom.watch.state().judges.front().impossible_now);
    boom.feed(1, 0, 30);
    CHECK(boom.noted == 1);
    CHECK(boom.watch.state().judges.front().impossible_now);
    CHECK(LinkJudge(boom.watch.state().judges.front()).verdict().kind == VerdictKind::sensor);
}

TEST_CASE(
    "a piston driven by oil that could not flow in, because the pressure reads above the supply's, is a sensor fault") {
    WatchedBoom boom;
    boom.feed(20, 0, 0);
    boom.feed(24, 0.09, 30, 4000);
    CHECK(boom.noted == 0);
    boom.feed(1, 0.09, 30, 4000);
    CHECK(boom.noted == 1);
    CHECK(LinkJudge(boom.watch.state().judges.front()).verdict().kind == VerdictKind::sensor);
}

TEST_CASE("a piston that comes to rest after a movement is not a sensor fault") {
    WatchedBoom boom;
    boom.feed(20, 0, 0);
    boom.feed(30, 0.09, 30);
    boom.feed(24, 0, 30);
    boom.feed(40, 0, 0);
    CHECK(boom.noted == 0);
}
