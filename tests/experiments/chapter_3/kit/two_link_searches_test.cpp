// Tests searches of bucket and boom together, the balance of their flows, and the plots of their states.

#include "experiments/chapter_3/kit/two_link_plots.hpp"
#include "experiments/chapter_3/kit/two_link_study.hpp"
#include "hydraulics/data/parameters.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;

namespace {

const TwoLinkMotion& both_links() {
    static const TwoLinkMotion motion = simulate_two_links();
    return motion;
}

IdentificationWay short_way() {
    IdentificationWay way = gray_way();
    way.usable.count = 8;
    return way;
}

} // namespace

TEST_CASE("the pump's flow divides at each junction: into the cylinder and on to the next one") {
    for (const ExcavatorState& state : both_links().motion.states) {
        if (state.time_s < 0.5) // the valves have opened, and no relief valve is open
            continue;
        const InternalStates states = true_states(state);
        REQUIRE(states.q_bucket + states.q11 ==
                doctest::Approx(both_links().scenario.flow.pump_in3_per_s).epsilon(1e-6));
        REQUIRE(states.q_boom + states.q12 == doctest::Approx(states.q11).epsilon(1e-6));
        REQUIRE(states.p11 >= states.p12); // the oil flows towards the tank
    }
}

TEST_CASE("at the end both links move steadily: the flow into a cylinder is its area times its velocity") {
    const ExcavatorState& end = both_links().motion.states.back();
    CHECK(end.time_s == doctest::Approx(4));
    const Parameters& machine = Parameters::excavator();
    CHECK(true_states(end).q_bucket ==
          doctest::Approx(machine["bucket.inlet_area"] * end.links[0].velocity_in_per_s).epsilon(0.002));
    CHECK(true_states(end).q_boom ==
          doctest::Approx(machine["boom.inlet_area"] * end.links[1].velocity_in_per_s).epsilon(0.002));
}

TEST_CASE("a search of both links is the search of the record that was measured with the same seed") {
    const TwoLinkSearch found = search_two_links(both_links(), low_noise, short_way(), 5);
    const ComplianceSearch prepared = measure_two_links(both_links(), low_noise, short_way(), 5);
    REQUIRE(found.prepared.samples.size() == prepared.samples.size());
    CHECK(found.prepared.samples.front().links == prepared.samples.front().links);
    const SearchRun again =
        search_transient(prepared.problem, prepared.samples, short_way(), RandomStream(5, "master"));
    REQUIRE(found.run.estimates.size() == again.estimates.size());
    CHECK(found.run.estimates.back().compliance_in3_per_psi == again.estimates.back().compliance_in3_per_psi);
}

TEST_CASE("many searches are one for each seed, in their order") {
    const std::vector<std::uint64_t> seeds{9, 4};
    const std::vector<SearchRun> runs = search_many(both_links(), low_noise, short_way(), seeds);
    REQUIRE(runs.size() == 2);
    for (std::size_t i = 0; i < 2; ++i)
        CHECK(runs[i].estimates.back().compliance_in3_per_psi ==
              search_two_links(both_links(), low_noise, short_way(), seeds[i])
                  .run.estimates.back()
                  .compliance_in3_per_psi);
    CHECK(runs[0].estimates.back().compliance_in3_per_psi != runs[1].estimates.back().compliance_in3_per_psi);
    CHECK(search_many(both_links(), low_noise, short_way(), {}).empty());
}

TEST_CASE("noise changes the readings, not the number or the times of the samples of a rising motion") {
    const ComplianceSearch clean = measure_two_links(both_links(), no_noise, short_way(), 1),
                           noisy = measure_two_links(both_links(), low_noise, short_way(), 1);
    CHECK(clean.samples.size() == 8);
    CHECK(noisy.samples.size() == 8);
    CHECK(clean.samples.front().links[1].inlet_psi != noisy.samples.front().links[1].inlet_psi);
    CHECK(std::abs(clean.samples.front().time_s - noisy.samples.front().time_s) <= 0.0401); // two samples
}

TEST_CASE("without noise, the improved search finds both compliances within 10 %, and the share counts it") {
    const std::vector<std::uint64_t> seeds{1, 2, 3};
    IdentificationWay way = gray_way();
    const std::vector<SearchRun> runs = search_many(both_links(), no_noise, way, seeds);
    for (const SearchRun& run : runs)
        CHECK(errors_of(run.estimates.back().compliance_in3_per_psi).both_within(10));
    CHECK(both_within_ten_percent(runs, 1000, way.search.window.trials) == 100);
}

TEST_CASE("Figure 3.9 has the states of the first two seconds, each from 0 on, in the units of its panel") {
    const Plot plot = plot_of_states(both_links());
    REQUIRE(plot.panels.size() == 3);
    CHECK(plot.panels[0].series.size() == 4);
    CHECK(plot.panels[1].series.size() == 4);
    CHECK(plot.panels[2].series.size() == 2);
    for (const Panel& panel : plot.panels)
        for (const Series& series : panel.series) {
            CHECK(series.points.front().x == 0);
            CHECK(series.points.back().x == doctest::Approx(2));
            CHECK(series.points.size() == 201); // every 10 ms
        }
    const auto state = std::ranges::find_if(both_links().motion.states,
                                            [](const ExcavatorState& each) { return each.time_s > 0.9995; });
    CHECK(plot.panels[0].series[3].name == "P_BOi");
    CHECK(plot.panels[0].series[3].points[100].y == state->links[1].inlet_psi);
    CHECK(plot.panels[1].series[0].name == "Q_11");
    CHECK(plot.panels[1].series[0].points[100].y == true_states(*state).q11);
    CHECK(plot.panels[2].series[1].points[100].y == state->links[1].velocity_in_per_s);
}

TEST_CASE("Figure 3.10 has each state twice in one colour: simulated, and identified at the samples") {
    const TwoLinkSearch found = search_two_links(both_links(), no_noise, gray_way(), 1);
    const Plot plot = plot_of_estimated_states(both_links(), found.prepared, found.run);
    for (const Panel& panel : plot.panels)
        for (std::size_t i = 0; i < panel.series.size(); i += 2) {
            const Series &simulated = panel.series[i], &identified = panel.series[i + 1];
            CHECK(simulated.name.ends_with(" simulated"));
            CHECK(identified.name ==
                  simulated.name.substr(0, simulated.name.size() - sizeof("simulated") + 1) + "identified");
            CHECK(simulated.colour == identified.colour);
            CHECK(identified.stroke == Stroke::points);
            CHECK(identified.points.size() == found.run.estimates.size());
            const Point& last = identified.points.back(); // the last answer is right, and so are its states
            const auto near = std::ranges::lower_bound(simulated.points, last.x - 0.001, {}, &Point::x);
            CHECK(last.y == doctest::Approx(near->y).epsilon(0.1));
        }
}
