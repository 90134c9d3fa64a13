// Tests plots and block diagrams of chapter 3.

#include "experiments/chapter_3/kit/block_diagrams.hpp"
#include "experiments/chapter_3/kit/boom_plots.hpp"
#include "experiments/chapter_3/kit/two_link_plots.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;

namespace {

std::size_t count_of_text(const std::string& svg, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = svg.find(part); at != svg.npos; at = svg.find(part, at + 1))
        ++count;
    return count;
}

} // namespace

TEST_CASE("a series over time ends at the given time or with its values") {
    const std::vector<double> time_s{0, 0.02, 0.04, 0.06}, values{5, 6, 7};
    CHECK(over_time("", time_s, values, 1).points.size() == 3);
    const Series early = over_time("name", time_s, values, 0.02, Stroke::dashes);
    REQUIRE(early.points.size() == 2);
    CHECK(early.points[1].x == 0.02);
    CHECK(early.points[1].y == 6);
    CHECK(early.stroke == Stroke::dashes);
}

TEST_CASE("Figure 3.3 shows the record's voltage as steps, and its spool beside the spool from the lag") {
    const BoomData data = measure({BoomPlant::simple}, 1);
    const Plot plot = plot_of_record("record", data, 1);
    REQUIRE(plot.panels.size() == 4);
    const std::vector<Point>& volts = plot.panels[1].series.at(0).points;
    REQUIRE(volts.size() > 2);
    for (std::size_t i = 1; i < volts.size(); ++i) // in each step only time or only voltage changes
        CHECK((volts[i].x == volts[i - 1].x || volts[i].y == volts[i - 1].y));
    CHECK(plot.panels[2].series.size() == 2);
    for (const Panel& panel : plot.panels)
        for (const Series& series : panel.series) {
            REQUIRE_FALSE(series.points.empty());
            CHECK(series.points.back().x <= 1);
        }
}

TEST_CASE("Figures 3.5 and 3.6 begin their angle at 0, and keep the last answer to the end") {
    const BoomData data = measure({BoomPlant::simple}, 1);
    const BoomModel model = model_of(data, AreasFrom::spool);
    const BoomIdentified identified = identify_boom(data, model, thesis_way(), 1);
    const std::vector<Generation> generations = watch_search(data, identified.samples, thesis_way(), 1);
    const Plot plot = plot_of_identification({"title", data, model, identified, generations}, 2);
    REQUIRE(plot.panels.size() == 5);
    CHECK(plot.panels[1].series[0].points.front().y == 0);
    const Series& answers = plot.panels[3].series[0];
    CHECK(answers.points.back().x == 2);
    CHECK(answers.points.back().y == 1000 * identified.compliance_in3_per_psi);
    CHECK(plot.panels[3].marks.at(0).y == doctest::Approx(8.6));
    REQUIRE(plot.panels[4].series[0].points.size() == generations.size());
    for (std::size_t i = 1; i < generations.size(); ++i) // the generations of one sample stand side by side
        CHECK(plot.panels[4].series[0].points[i].x > plot.panels[4].series[0].points[i - 1].x);
}

TEST_CASE("Figure 3.11 counts generations, five a sample, and marks both true compliances") {
    const TwoLinkMotion motion = simulate_two_links();
    const IdentificationWay way = gray_way();
    const ComplianceSearch prepared = measure_two_links(motion, no_noise, way, 1);
    const SearchRun run = search_transient(prepared.problem, prepared.samples, way, RandomStream(1, "master"));
    const Plot plot = plot_of_compliances(prepared, run, run, 5);
    REQUIRE(plot.panels.size() == 3);
    const Series& bucket = plot.panels[0].series.at(0);
    CHECK(bucket.points.size() == run.estimates.size());
    CHECK(bucket.points.front().x == 5);
    CHECK(bucket.points.back().x == 5.0 * static_cast<double>(run.estimates.size()));
    CHECK(bucket.points.back().y == 1000 * run.estimates.back().compliance_in3_per_psi[0]);
    CHECK(plot.panels[0].marks.size() == 2);
    const Plot states = plot_of_estimated_states(motion, prepared, run);
    CHECK(states.panels.at(0).series.size() == 4); // two pressures,
    CHECK(states.panels.at(1).series.size() == 8); // and four flows, each simulated and identified
}

TEST_CASE("block diagrams have wires, and a text in each block") {
    for (const std::string& svg : {draw_figure_3_4(), draw_figure_3_7()}) {
        CHECK(svg.starts_with("<svg "));
        CHECK(count_of_text(svg, "<rect ") >= 4);
        CHECK(count_of_text(svg, "class=\"wire\"") >= 4);
        CHECK(count_of_text(svg, "class=\"inside\"") >= count_of_text(svg, "class=\"block"));
        CHECK(count_of_text(svg, "<g") == count_of_text(svg, "</g>"));
    }
    CHECK(draw_figure_3_4() != draw_figure_3_7());
}
