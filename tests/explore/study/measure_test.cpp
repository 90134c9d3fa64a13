// Tests the figures of a run, and the message for a measure that no run has.

#include "explore/study/measure.hpp"

#include "explore/problems.hpp"
#include "gaprocs/problem_registry.hpp"
#include "netlist/read.hpp"
#include "netlist/run_report.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace placedpar;
using namespace std::chrono_literals;

namespace {

/// Returns a run of 10 ms on two processors. The first processor computed for a quarter of the time.
RunReport quarter_busy() {
    RunReport report;
    report.result.ending = Ending::completed;
    report.result.time = 10ms;
    report.processors = {{"t[0]", "T800", 2500us, 0ms, 0, 0ms}, {"t[1]", "T800", 0ms, 0ms, 0, 0ms}};
    report.measurements = {{"master", "rate", 12.5, "1/s"},
                           {"master", "state", std::string("idle"), ""},
                           {"master", "error", std::numeric_limits<double>::infinity(), ""}};
    return report;
}

std::vector<std::string> names_in(const StudyFigures& figures) {
    std::vector<std::string> names;
    for (const auto& each : figures)
        names.push_back(each.first);
    return names;
}

/// Returns the measures available for runs of a farm.
PossibleMeasures of_a_farm() {
    const ProblemRegistry problems = known_problems(0);
    const Catalogue kinds = known_kinds(problems);
    const ReadResult read = read_netlist(std::string(PLACEDPAR_SOURCE_DIR) + "/examples/genetic/farms/farm.cfs", kinds);
    INFO(render(read));
    REQUIRE(read.network);
    PossibleMeasures possible;
    possible.add(*read.network, kinds, problems);
    return possible;
}

} // namespace

TEST_CASE("a run's figures are its time, the size of its machine, numeric measurements and the load of processors") {
    const StudyFigures figures = figures_of(quarter_busy(), Network());
    CHECK(names_in(figures) == std::vector<std::string>{"links", "master.error", "master.rate", "processors",
                                                        "t[0].busy", "t[1].busy", "time"});
    CHECK(std::isnan(figures.at("master.error").value)); // infinity is no figure
    CHECK(figures.at("time").value == 10);
    CHECK(figures.at("time").unit == "ms");
    CHECK(figures.at("processors").value == 2);
    CHECK(figures.at("master.rate").unit == "1/s");
    CHECK(figures.at("t[0].busy").value == 25);
    CHECK(figures.at("t[0].busy").unit == "%");
    CHECK(StudyMeasure("t.busy").of(figures)->value == 12.5);
}

TEST_CASE("the mean and the sum over processes are missing if one process has no number, the extremes are not") {
    const StudyFigures islands{{"island[0].best", {3, ""}}, {"island[1].best", {std::nan(""), ""}}};
    for (const char* all : {"island.best", "mean(island.best)", "sum(island.best)", "island[1].best"}) {
        CHECK_FALSE_MESSAGE(StudyMeasure(all).of(islands), all);
        CHECK_MESSAGE(StudyMeasure(all).is_in(islands), all);
    }
    CHECK(StudyMeasure("island[0].best").of(islands)->value == 3);
    CHECK(StudyMeasure("min(island.best)").of(islands)->value == 3);
    CHECK(StudyMeasure("max(island.best)").of(islands)->value == 3);
    CHECK_FALSE(StudyMeasure("island.worst").is_in(islands));
    CHECK(there_is_no_measure(StudyMeasure("island.best"), islands) == "a run measured no number as \"island.best\"");
}

TEST_CASE("a figure that is no number is stored as such") {
    const StudyFigures read =
        figures_from(figures_text({{"a", {1.5, "ms"}}, {"b", {std::nan(""), "s"}}, {"c", {2, ""}}}));
    CHECK(read.at("a").value == 1.5);
    CHECK(std::isnan(read.at("b").value));
    CHECK(read.at("b").unit == "s");
    CHECK(read.at("c").value == 2);
}

TEST_CASE("after a deadlock no load of processors is reported") {
    RunReport stuck = quarter_busy();
    stuck.result.ending = Ending::stuck;
    CHECK_FALSE(figures_of(stuck, Network()).contains("t[0].busy"));
}

TEST_CASE("a table names a measure by its last part, without aggregate and subscript") {
    CHECK(StudyMeasure("max(master[0].T_exe)").name_without_subscripts() == "master.T_exe");
    CHECK(StudyMeasure("max(master[0].T_exe)").last_name() == "T_exe");
    CHECK(StudyMeasure("cell[1][2].in.bytes").name_without_subscripts() == "cell.bytes");
    CHECK(StudyMeasure("time").last_name() == "time");
    for (const char* none : {"", "max()", "max(a,b)", "f(x)", "a)"})
        CHECK_THROWS_WITH_AS(StudyMeasure{none}, doctest::Contains("is not a measure: expected time, PROCESS.NAME"),
                             UserError);
}

TEST_CASE("stored figures in a form that is never written are refused") {
    for (const char* wrong : {"", "{", "[1]", "{\"a\":1}", "{\"a\":[1]}", "{\"a\":[\"1\",\"ms\"]}", "{\"a\":[1,2]}",
                              "{\"a\":[1,\"\"],\"a\":[2,\"\"]}", "{\"a\":[1e999,\"\"]}"}) {
        CAPTURE(wrong);
        CHECK_THROWS(figures_from(wrong));
    }
    CHECK(figures_from("{}").empty());
}

TEST_CASE("the possible measures of machine, kinds and problem are known before any run") {
    const PossibleMeasures possible = of_a_farm();
    for (const char* measure :
         {"time", "processors", "links", "t.busy", "max(t[1].busy)", "master.T_exe", "master.C_BOi"})
        CHECK_MESSAGE(possible.has(StudyMeasure(measure)), measure);
    for (const char* measure : {"speed", "u.busy", "master.T_ex", "host.T_exe"})
        CHECK_FALSE_MESSAGE(possible.has(StudyMeasure(measure)), measure);
    CHECK(possible.why_unknown(StudyMeasure("max(master[0].T_ex)")) ==
          "unknown measure \"master.T_ex\"; did you mean \"master.T_exe\"?");
}

TEST_CASE("a measure that a run lacks is refused with the nearest name, or with all measures") {
    const StudyFigures figures = figures_of(quarter_busy(), Network());
    CHECK(there_is_no_measure(StudyMeasure("master.rates"), figures) ==
          "unknown measure \"master.rates\"; did you mean \"master.rate\"?");
    CHECK(there_is_no_measure(StudyMeasure("wall clock"), figures) ==
          "unknown measure \"wall clock\"; the runs have the measures links, master.error, master.rate, processors, "
          "t.busy, time");
}

TEST_CASE("if runs ended before a measurement, the message describes the measure") {
    const StudyFigures host{{"host.estimates", {20, ""}}, {"host.response", {3, "ms"}}};
    CHECK(there_is_no_measure(StudyMeasure("host.accurate_after"), host) ==
          "no run measured \"host.accurate_after\": time after which the fittest estimate stays accurate; absent if "
          "the last estimate is not accurate");
}
