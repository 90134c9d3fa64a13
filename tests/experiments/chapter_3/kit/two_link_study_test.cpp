// Tests bucket and boom together: errors of both compliances, and the circuit's internal states.

#include "experiments/chapter_3/kit/two_link_study.hpp"

#include "hydraulics/data/parameters.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;

namespace {

/// Returns compliances that are these multiples of the machine's own.
std::vector<double> times_true(double bucket, double boom) {
    const Parameters& machine = Parameters::excavator();
    return {bucket * machine["bucket.inlet_compliance"], boom * machine["boom.inlet_compliance"]};
}

/// A search that found these values, one after the other.
SearchRun search_through(const std::vector<std::vector<double>>& found) {
    SearchRun run;
    for (const std::vector<double>& compliances : found)
        run.estimates.push_back({0, 0, false, 0, compliances});
    return run;
}

} // namespace

TEST_CASE("errors are absolute percentages of the machine's compliances") {
    const TwoErrors errors = errors_of(times_true(1.1, 0.8));
    CHECK(errors.bucket == doctest::Approx(10));
    CHECK(errors.boom == doctest::Approx(20));
    CHECK(errors.both_within(20.001));
    CHECK_FALSE(errors.both_within(19)); // the larger error counts
    CHECK_FALSE(errors_of(times_true(1.3, 1)).both_within(20));
}

TEST_CASE("the share of right searches uses the last estimate of a search that has ended") {
    const auto right = times_true(1.05, 0.95), wrong = times_true(1, 1.2);
    const std::vector<SearchRun> runs{search_through({right, right, wrong}), search_through({wrong, right, right}),
                                      search_through({wrong, right}), search_through({wrong, wrong, wrong})};
    CHECK(both_within_ten_percent(runs, 5, 5) == 25); // five generations a sample
    CHECK(both_within_ten_percent(runs, 14, 5) == 75);
    CHECK(both_within_ten_percent(runs, 15, 5) == 50);
    CHECK(both_within_ten_percent(runs, 1000, 5) == 50);
}

TEST_CASE("the improved method has an elite and skips two samples; the next one adds Gray code") {
    const IdentificationWay thesis = thesis_way(), elite = elite_way(), gray = gray_way();
    CHECK(thesis.search.elite == 0);
    CHECK(elite.search.elite == 1);
    CHECK(elite.usable.skipped == 2);
    CHECK(elite.coding == thesis.coding);
    CHECK(gray.coding == Coding::gray);
    CHECK(gray.search.elite == 1);
    CHECK(gray.usable.skipped == 2);
}

TEST_CASE("internal states agree with equations 3.5 to 3.7 computed by hand") {
    const FlowConstants flow{
        .orifice_in3_per_s_in2_sqrt_psi = 100, .pump_in3_per_s = 175, .tank_psi = 25, .relief_psi = 2500};
    const CircuitSample sample{
        0, 0, {{1000, 500, 10, 0.02, 0.05}, {900, -100, 22, 0.04, 0.03}}}; // pressure, slope, flow, a_i, a_e
    const std::vector<double> compliances{0.004, 0.02};
    const InternalStates states = estimated_states(sample, compliances, flow);
    CHECK(states.q_bucket == doctest::Approx(10 + 500 * 0.004));     // 12
    CHECK(states.q_boom == doctest::Approx(22 - 100 * 0.02));        // 20
    CHECK(states.p11 == doctest::Approx(1000 + 6.0 * 6.0));          // (12 / (100 * .02))^2
    CHECK(states.p12 == doctest::Approx(900 + 5.0 * 5.0));           // (20 / (100 * .04))^2
    CHECK(states.q11 == doctest::Approx(5 * std::sqrt(1036 - 925))); // to the second junction
    CHECK(states.q12 == doctest::Approx(3 * std::sqrt(925 - 25)));   // 90, to the tank
}

TEST_CASE("the true compliances give back the states of the simulated circuit, to the slopes of five readings") {
    const TwoLinkMotion motion = simulate_two_links();
    const ComplianceSearch prepared = measure_two_links(motion, no_noise, gray_way(), 1);
    REQUIRE(prepared.samples.size() >= 10);
    for (const CircuitSample& sample : prepared.samples) {
        const auto state = std::ranges::min_element(motion.motion.states, {}, [&](const ExcavatorState& each) {
            return std::abs(each.time_s - sample.time_s);
        });
        const auto simulated = true_states(*state).values();
        const auto estimated = estimated_states(sample, times_true(1, 1), prepared.flow).values();
        CAPTURE(sample.time_s);
        for (std::size_t i = 0; i < InternalStates::count; ++i)
            CHECK(estimated[i] == doctest::Approx(simulated[i]).epsilon(0.05));
    }
}
