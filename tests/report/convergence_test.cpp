// Tests the curves over generations, with bands over the seeds.

#include "report/convergence.hpp"

#include "report/search_report.hpp"
#include "tests/report/small_log.hpp"
#include "text/user_error.hpp"

#include <boost/json.hpp>
#include <doctest/doctest.h>

#include <limits>
#include <stdexcept>

using namespace placedpar;

TEST_CASE("a curve is the median of the runs with a band between the quartiles") {
    ConvergenceCurve curve{"best", {{1, 10}, {2, 20, 5}, {3, 30}, {9, 90}}, 4};
    Panel panel = convergence_panel("title", "fitness [1]", {&curve, 1});
    REQUIRE(panel.series.size() == 1);
    REQUIRE(panel.series[0].points.size() == 2); // only generations that all runs have made
    CHECK(panel.series[0].points[1].x == 2);
    CHECK(panel.series[0].points[1].y == 25);
    CHECK(panel.series[0].colour == 4);
    REQUIRE(panel.bands.size() == 1);
    CHECK(panel.bands[0].points[1].low == 10);
    CHECK(panel.bands[0].points[1].high == 30);
    CHECK(panel.x.label == "generation");
    CHECK(panel.y.label == "fitness [1]");
}

TEST_CASE("a single run has no band") {
    ConvergenceCurve curve{"best", {{1, 10}}, 0};
    CHECK(convergence_panel("", "", {&curve, 1}).bands.empty());
}

TEST_CASE("long runs are thinned out, but keep the last generation") {
    ConvergenceCurve curve{"best", {std::vector<double>(100'001, 1.0)}, 0};
    curve.runs[0].back() = 2;
    auto points = convergence_panel("", "", {&curve, 1}).series[0].points;
    CHECK(points.size() < 500);
    CHECK(points.front().x == 1);
    CHECK(points.back().x == 100'001);
    CHECK(points.back().y == 2);
}

TEST_CASE("comparable searches are plotted together, with the diversity between them") {
    std::vector<SeededLog> logs{{1, GenerationLog({"east", "west"})}, {2, GenerationLog({"east", "west"})}};
    for (SeededLog& each : logs)
        for (const char* search : {"east", "west"})
            test::tell(each.log, search, 1, {1, 3});
    Plot plot = convergence_plot("title", logs);
    REQUIRE(plot.panels.size() == 2);
    CHECK(plot.panels[0].title == "fitness, medians and quartiles of 2 seeds");
    CHECK(plot.panels[0].series.size() == 2);
    CHECK(plot.panels[1].series.size() == 2);
    CHECK(plot.panels[0].bands.size() == 1); // the mean has no band
    CHECK(plot.panels[0].series[0].stroke == Stroke::points);
    CHECK(plot.panels[1].bands.size() == 2);
    CHECK(draw_svg(plot).find("between them") != std::string::npos);
}

TEST_CASE("searches with different problems are drawn separately") {
    SeededLog seeded{3, GenerationLog({"east", "west"}, false)};
    test::tell(seeded.log, "east", 1, {1, 3});
    CHECK_THROWS_AS(convergence_plot("", {&seeded, 1}), UserError); // the other search has not made a generation
    test::tell(seeded.log, "west", 1, {2, 4});
    Plot plot = convergence_plot("title", {&seeded, 1});
    REQUIRE(plot.panels.size() == 4);
    CHECK(plot.panels[2].title == "west: fitness, seed 3");
    CHECK(plot.panels[2].series[1].points[0].y == 4);
    CHECK(plot.panels[3].series.size() == 1);
}

TEST_CASE("a positive minimised objective has a logarithmic axis") {
    SeededLog seeded{1, GenerationLog({"east"})};
    std::vector<Genome> population{Genome::from_string("00"), Genome::from_string("01")};
    std::vector<double> fitness{-2, -400}, solved{0, -1};
    seeded.log.observe({"east", 1, std::nullopt, BitString(2), population, fitness, Goal::minimise});
    Plot plot = convergence_plot("", {&seeded, 1});
    CHECK(plot.panels[0].y.logarithmic);
    CHECK(plot.panels[0].y.label == "objective");
    CHECK(plot.panels[0].series[0].name == "best so far");
    CHECK(plot.panels[0].series[0].points[0].y == 2);
    seeded.log.observe({"east", 2, std::nullopt, BitString(2), population, solved, Goal::minimise});
    CHECK_FALSE(convergence_plot("", {&seeded, 1}).panels[0].y.logarithmic);
}

TEST_CASE("a curve leaves out objectives that are not finite") {
    double infinite = std::numeric_limits<double>::infinity();
    ConvergenceCurve curve{"best", {{infinite, 3, 2}, {infinite, infinite, 1}}, 0};
    Panel panel = convergence_panel("", "", {&curve, 1});
    REQUIRE(panel.series[0].points.size() == 1);
    CHECK(panel.series[0].points[0].x == 3);
    CHECK(panel.bands[0].points.size() == 1);
    SeededLog seeded{1, GenerationLog({"east"})};
    test::tell(seeded.log, "east", 1, {worst_fitness, worst_fitness}, std::nullopt, Goal::maximise);
    CHECK_THROWS_AS(convergence_plot("", {&seeded, 1}), UserError);
    test::tell(seeded.log, "east", 2, {worst_fitness, 2}, std::nullopt, Goal::maximise);
    CHECK(convergence_plot("", {&seeded, 1}).panels[0].series[0].points.size() == 1);
    CHECK(searches_json(seeded.log)[0].at("generation_at_99_percent") == 2);
    CHECK(searches_json(seeded.log)[0].at("first").at("best").is_null()); // JSON has no number for it
    CHECK(searches_json(seeded.log)[0].at("last").at("best") == 2.0);
}

TEST_CASE("a plot without anything to draw is refused") {
    ConvergenceCurve none{"none", {}, 0}, empty{"empty", {{1}, {}}, 0};
    CHECK_THROWS_AS(convergence_panel("", "", {&none, 1}), std::invalid_argument);
    CHECK_THROWS_AS(convergence_panel("", "", {&empty, 1}), std::invalid_argument);
}
