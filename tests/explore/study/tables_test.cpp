// Tests which runs a study's tables need, and what their cells show.

#include "explore/study/comparisons.hpp"
#include "explore/study/study_file.hpp"
#include "explore/study/sweep.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>

using namespace placedpar;

namespace {

Study study_in(const std::string& text) {
    const auto path = std::filesystem::temp_directory_path() / "placedpar_tables_test.toml";
    std::ofstream(path) << text;
    Study study = read_study(path.string());
    std::filesystem::remove(path);
    return study;
}

/// Returns the rate of a made-up machine: 10 with one processor, 1 less for each further processor, plus the seed.
StudyFigures rate_of(const StudyRun& run) {
    const double processors = std::stod(run.set.contains("slaves") ? run.set.at("slaves") : "0") + 1;
    return {{"master.rate", {processors * (11 - processors) + static_cast<double>(run.seed), "1/s"}},
            {"time", {2.5, "ms"}}};
}

std::vector<Comparison> tables_of(Study study) {
    study.function = rate_of;
    StudyResults results(StudySource{});
    Interruption never;
    StudySweep(study, results).run(2, never, [](std::uint64_t) {});
    return comparisons_of(study, results);
}

std::vector<double> simulated(const Comparison& table) {
    std::vector<double> figures;
    for (const Cell& cell : table.cells)
        figures.push_back(cell.simulated);
    return figures;
}

const std::string head = "netlist = \"any.cfs\"\nfirst_seed = 0\nmeasure = [\"master.rate\", \"time\"]\n";
const std::string columns = "columns = [{name = \"alone\", set = {slaves = 0}}, {name = \"one\", set = {slaves = 1}}, "
                            "{name = \"two\", set = {slaves = 2}}]\n";

void check_study_refused(const std::string& text, const std::string& why) {
    CAPTURE(text);
    CHECK_THROWS_WITH_AS(study_in(text), doctest::Contains(why.c_str()), RefusedInput);
}

} // namespace

TEST_CASE("a table needs a run for each row and column, and no other run") {
    Study study =
        study_in(head + "[[table]]\nname = \"x\"\nset = {reading = 30}\n" + columns +
                 "rows = [{name = \"a\", figure = \"rate\"}, {name = \"b\", figure = \"rate\", set = {clock = "
                 "\"5M\"}, relative_to = {slaves = 0}}]\n");
    CHECK(study.count() == 6);
    CHECK(study.at(1)->set == Overrides{{"reading", "30"}, {"slaves", "1"}});
    CHECK(study.at(5)->set == Overrides{{"clock", "5M"}, {"reading", "30"}, {"slaves", "2"}});
}

TEST_CASE("runs are made in the order of the file, beginning with [set]") {
    Study study = study_in(head + "[set]\nslaves = 9\n[[table]]\nname = \"x\"\n" + columns +
                           "rows = [{name = \"a\", figure = \"rate\"}]\n[[also]]\nset = {slaves = 5}\n");
    std::vector<std::string> slaves;
    for (std::uint64_t i = 0; i < study.count(); ++i)
        slaves.push_back(study.at(i)->set.at("slaves"));
    CHECK(slaves == std::vector<std::string>{"9", "0", "1", "2", "5"});
}

TEST_CASE("a cell has the figure of its run, the known figure and the tolerance") {
    Comparison table =
        tables_of(study_in(head + "[[table]]\nname = \"x\"\nagainst = \"thesis\"\n" + columns +
                           "rows = [{name = \"rate\", figure = \"rate\", unit = \"1/s\", decimals = 1, known "
                           "= [10, nan, \"9 * (slaves + 1)\"], tolerance = [\"3 %\", \"3 %\", \".01 * "
                           "known\"], origin = [\"workload\", "
                           "\"outcome\", \"outcome\"]}]\n"))
            .at(0);
    CHECK(simulated(table) == std::vector<double>{10, 18, 24});
    CHECK(table.against == "thesis");
    const Cell &alone = table.cells[0], &one = table.cells[1], &two = table.cells[2];
    CHECK(alone.column == "alone");
    CHECK(two.column == "two");
    CHECK(alone.reference == 10);
    CHECK(alone.tolerance_percent == 3);
    CHECK(alone.origin == Origin::workload);
    CHECK_FALSE(one.reference);
    CHECK_FALSE(one.tolerance_percent);
    CHECK(two.reference == 27);
    CHECK(*two.tolerance == doctest::Approx(.27));
    CHECK(two.origin == Origin::outcome);
    CHECK_FALSE(table.within_tolerance());
}

TEST_CASE("a row can name a judge that differs from its table's judge") {
    Comparison table =
        tables_of(study_in(head + "[[table]]\nname = \"x\"\nagainst = \"thesis\"\nknown = 1\ntolerance = 1\n" +
                           columns +
                           "rows = [{name = \"a\", figure = \"rate\"}, {name = \"b\", figure = "
                           "\"rate\", judge = \"own\"}]\n"))
            .at(0);
    CHECK(table.judge_of(table.cells.front()) == Judge::thesis);
    CHECK(table.judge_of(table.cells.back()) == Judge::own);
}

TEST_CASE("figures can be relative to a run and can use the rows above") {
    Comparison table =
        tables_of(study_in(head + "[[table]]\nname = \"x\"\n" + columns +
                           "relative_to = {slaves = 0}\nrows = [{name = \"speedup\", figure = \"rate\"}, "
                           "{name = \"efficiency\", figure = \"speedup / (slaves + 1)\"}, {name = "
                           "\"per slave\", figure = \"rate / (slaves + 1)\"}]\n"))
            .at(0);
    CHECK(simulated(table) == std::vector<double>{1, 1.8, 2.4, 1, .9, 2.4 / 3, 1, .9, 2.4 / 3});
}

TEST_CASE("a figure is the mean over the seeds") {
    const std::string table = "[[table]]\nname = \"x\"\n" + columns + "rows = [{name = \"a\", figure = \"rate\"}]\n";
    CHECK(simulated(tables_of(study_in("seeds = 3\n" + head + table)).at(0)) == std::vector<double>{11, 19, 25});
}

TEST_CASE("a row can show the 95 % interval of its mean, and must miss a bound with all of it to miss it") {
    Comparison table = tables_of(study_in("seeds = 3\n" + head + "[[table]]\nname = \"x\"\n" + columns +
                                          "rows = [{name = \"a\", figure = \"rate\", interval = true, at_least = [13, "
                                          "nan, \"slaves + 11\"], at_most = [nan, 16, nan]}]\n"))
                           .at(0);
    // The rates of seeds 0 to 2 are 10, 11 and 12 with one processor. Student's t of two degrees of freedom is 4.303.
    const double half_width = 4.302653 / std::sqrt(3);
    REQUIRE(table.cells.size() == 9);
    CHECK(table.cells[3].row == "a, 95 % from");
    CHECK(table.cells[3].column == "alone");
    CHECK(table.cells[3].simulated == doctest::Approx(11 - half_width));
    CHECK(table.cells[6].row == "a, to");
    CHECK(table.cells[6].simulated == doctest::Approx(11 + half_width));
    CHECK(table.cells[0].within_tolerance());
    CHECK_FALSE(table.cells[1].within_tolerance());
    CHECK(table.cells[2].at_least == 13);
}

TEST_CASE("a figure in percent that is 0 or 100 in each run is a share of the runs") {
    Comparison table = tables_of(study_in("seeds = 3\n" + head + "[[table]]\nname = \"x\"\n" + columns +
                                          "rows = [{name = \"a\", figure = \"100 * (rate > 10)\", unit = \"%\", "
                                          "interval = true}]\n"))
                           .at(0);
    CHECK(simulated(table).at(0) == doctest::Approx(200. / 3));
    CHECK(simulated(table).at(3) == doctest::Approx(9.43).epsilon(.001)); // Clopper and Pearson's interval for 2 of 3
    CHECK(simulated(table).at(6) == doctest::Approx(99.16).epsilon(.001));
}

TEST_CASE("a table can copy another table, and rows inherit from the table, except for stated keys") {
    std::vector<Comparison> tables = tables_of(study_in(
        head + "[[table]]\nname = \"x\"\nunit = \"1/s\"\nfigure = \"rate\"\njudged = true\nnotes = \"of x\"\n" +
        columns +
        "rows = [{name = \"a\"}, {name = \"b\", figure = \"time\", unit = \"ms\"}]\n[[table]]\nname = \"y\"\nlike = "
        "\"x\"\nfigure = \"2 * rate\"\nnotes = \"\"\n"));
    CHECK(tables.at(0).notes == "of x");
    CHECK(tables.at(1).notes.empty());
    CHECK(tables.at(1).judged);
    CHECK(simulated(tables.at(1)) == std::vector<double>{20, 36, 48, 2.5, 2.5, 2.5});
    CHECK(tables.at(1).cells.front().unit == "1/s");
    CHECK(tables.at(1).cells.back().unit == "ms");
}

TEST_CASE("errors in a table are refused with their place") {
    const std::string table = head + "[[table]]\nname = \"x\"\n", rows = "rows = [{name = \"a\", figure = \"rate\"}]\n";
    check_study_refused(table + rows, "the table lacks columns or rows");
    check_study_refused(table + columns, "the table lacks columns or rows");
    check_study_refused(table + columns + "rows = [{name = \"a\"}]\n", "the row lacks a figure");
    check_study_refused(table + columns + rows + "tolerence = 1\n", "did you mean \"tolerance\"?");
    check_study_refused(table + columns + "rows = [{name = \"a\", figure = \"rate\", knwon = 1}]\n",
                        "a row has no key \"knwon\"");
    check_study_refused(table + columns + rows + "like = \"y\"\n", "no earlier table has the name \"y\"");
    check_study_refused(table + columns + rows + "like = \"y\"\n", "\"like\" takes the name of an earlier table");
    check_study_refused(table + columns + rows + "known = [1, 2, 3, 4]\n",
                        "the list has more values than the table has columns: 4 values, 3 columns");
    check_study_refused(table + columns + rows + "known = [1, 2, 3, 4]\n",
                        "give one value for each column, or a single value without brackets for all of them");
    check_study_refused(table + columns + rows + "origin = \"guess\"\n", "unknown origin \"guess\"");
    check_study_refused(table + columns + rows + "origin = \"guess\"\n",
                        "expected \"outcome\", \"calibrated\", \"workload\", \"fitted\" or \"constant\"");
    check_study_refused(table + columns + rows + "judge = \"me\"\n", "unknown judge \"me\"");
    check_study_refused(table + columns + "rows = [{name = \"a\", figure = \"rate /\"}]\n", "the text cannot be read");
    check_study_refused(table + "columns = [{name = \"a\", set = {a = \"0..1\"}}]\n" + rows,
                        "\"a\" has several values here");
    check_study_refused(head + "table = 1\n", "\"table\" must be a list of tables");
}

TEST_CASE("missing figures and runs that did not complete are reported") {
    const std::string table = "[[table]]\nname = \"x\"\n" + columns + "rows = [{name = \"a\", figure = \"speed\"}]\n";
    const Comparison missing = tables_of(study_in("netlist = \"any.cfs\"\nmeasure = \"master.speed\"\n" + table)).at(0);
    CHECK(missing.notes.find("unknown measure \"master.speed\"") != std::string::npos);
    CHECK_THROWS_WITH_AS(study_in(head + table), doctest::Contains("the name \"speed\" is undefined"), RefusedInput);
    StudyResults none(StudySource{});
    CHECK_THROWS_WITH_AS(comparisons_of(study_in("netlist = \"any.cfs\"\nmeasure = \"master.speed\"\n" + table), none),
                         doctest::Contains("has not been made"), std::invalid_argument);
}
