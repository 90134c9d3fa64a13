// Tests faulty tables of a study: each is refused with its place, or its cell is left without a figure.

#include "explore/study/comparisons.hpp"
#include "explore/study/study_file.hpp"
#include "explore/study/sweep.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

using namespace placedpar;

namespace {

Study farm_study(const std::string& text) {
    const auto path = std::filesystem::temp_directory_path() / "placedpar_table_refusals_test.toml";
    std::ofstream(path) << text;
    Study study = read_study(path.string());
    std::filesystem::remove(path);
    return study;
}

/// This head has four lines, so the text after it starts at line 5.
const std::string farm_head = "netlist = \"any.cfs\"\nmeasure = [\"min(t.busy)\", \"max(t.busy)\", \"m.rate\"]\n"
                              "[[table]]\nname = \"x\"\n";
const std::string farm_columns = "columns = [{name = \"alone\", set = {slaves = 0}}, {name = \"one\", set = {slaves = "
                                 "1}}]\n";

std::string farm_rows(const std::string& more) {
    return "rows = [{name = \"a\", figure = \"rate\"" + (more.empty() ? "" : ", " + more) + "}]\n";
}

void check_farm_refused(const std::string& text, const std::string& why) {
    CAPTURE(text);
    CHECK_THROWS_WITH_AS(farm_study(text), doctest::Contains(why.c_str()), RefusedInput);
}

/// Runs the table of a farm that deadlocks with one slave.
Comparison farm_table(const Study& study) {
    StudyResults results(StudySource{});
    for (std::uint64_t i = 0; i < study.count(); ++i) {
        const StudyRun run = *study.at(i);
        const bool whole = run.set.at("slaves") != "1";
        results.keep(run, {.ended = whole ? "completed" : "deadlock",
                           .figures = {{"t[0].busy", {20, "%"}}, {"t[1].busy", {50, "%"}}, {"m.rate", {8, "1/s"}}}});
    }
    return comparisons_of(study, results).at(0);
}

} // namespace

TEST_CASE("tables, columns and rows need distinct names") {
    const std::string nameless = "netlist = \"any.cfs\"\nmeasure = \"m.rate\"\n[[table]]\n";
    check_farm_refused(nameless + farm_columns + farm_rows(""), ":3:1: error: the table lacks a name");
    check_farm_refused(farm_head + farm_columns + farm_rows("") + "[[table]]\nname = \"x\"\nlike = \"x\"\n",
                       ":8:8: error: two tables have the name \"x\"");
    check_farm_refused(farm_head + "columns = [{set = {slaves = 1}}]\n" + farm_rows(""),
                       ":5:12: error: the column lacks a name");
    check_farm_refused(farm_head + "columns = [{name = \"a\"}, {name = \"a\"}]\n" + farm_rows(""),
                       "two columns of the table have the name \"a\"");
    check_farm_refused(farm_head + farm_columns + "rows = [{figure = \"rate\"}]\n", "the row lacks a name");
    check_farm_refused(farm_head + farm_columns +
                           "rows = [{name = \"a\", figure = \"rate\"},\n{name = \"a\", figure = \"rate\"}]\n",
                       ":7:9: error: two rows of the table have the name \"a\"");
}

TEST_CASE("a table copies another only if it has the key like") {
    check_farm_refused(farm_head + farm_columns + farm_rows("") + "[[table]]\nname = \"y\"\n" + farm_rows(""),
                       ":7:1: error: the table lacks columns or rows");
}

TEST_CASE("an ambiguous or unknown name in an expression is refused when the file is read") {
    auto rows = [](const std::string& text) { return farm_head + farm_columns + "rows = [" + text + "]\n"; };
    check_farm_refused(rows("{name = \"a\", figure = \"rat\"}"),
                       ":6:31: error: the name \"rat\" is undefined; did you mean \"rate\"?");
    check_farm_refused(rows("{name = \"a\", figure = \"2 * busy\"}"),
                       "\"busy\" is ambiguous: it stands for the measure max(t.busy) and for the measure min(t.busy)");
    check_farm_refused(rows("{name = \"rate\", figure = \"2 * rate\"}, {name = \"b\", figure = \"rate + 1\"}"),
                       "\"rate\" is ambiguous: it stands for the measure m.rate and for the row above");
    check_farm_refused(rows("{name = \"slaves\", figure = \"rate\"}, {name = \"b\", figure = \"slaves\"}"),
                       "\"slaves\" is ambiguous: it stands for the row above and for the setting slaves");
    check_farm_refused(rows("{name = \"b\", figure = \"a\"}, {name = \"a\", figure = \"rate\"}"),
                       "the name \"a\" is undefined");
    check_farm_refused(farm_head + farm_columns + farm_rows("known = \"rate\""), "the name \"rate\" is undefined");
    check_farm_refused(farm_head + farm_columns + farm_rows("at_least = \"rate\""), "the name \"rate\" is undefined");
    check_farm_refused(farm_head + farm_columns + farm_rows("known = \"1 / slaves\""), "division by zero");
    check_farm_refused(farm_head + farm_columns + farm_rows("known = 1, tolerance = \"knwon\""),
                       "did you mean \"known\"?");
    check_farm_refused(farm_head + "set = {\"a.clock\" = 1, \"b.clock\" = 2}\n" + farm_columns +
                           farm_rows("known = \"clock\""),
                       "\"clock\" is ambiguous: it stands for the setting a.clock and for the setting b.clock");
}

TEST_CASE("without a measure figures are made of the time") {
    Study study = farm_study("netlist = \"any.cfs\"\n[[table]]\nname = \"x\"\n" + farm_columns +
                             "rows = [{name = \"a\", figure = \"time / 1000\"}]\n");
    CHECK(study.figures == std::vector<std::string>{"time"});
}

TEST_CASE("lists need a value for each column, also in a table that copies another") {
    for (const char* name : {"known", "tolerance", "origin"}) {
        check_farm_refused(farm_head + farm_columns + farm_rows(std::string(name) + " = [\"1\"]"),
                           "the list has fewer values than the table has columns: 1 value, 2 columns");
        check_farm_refused(farm_head + farm_columns + farm_rows(std::string(name) + " = []"), "0 values, 2 columns");
    }
    const std::string first = farm_head + farm_columns + farm_rows("known = 8, tolerance = 1");
    Study study = farm_study(first +
                             "[[table]]\nname = \"y\"\nlike = \"x\"\ncolumns = [{name = \"1\"}, {name = "
                             "\"2\"}, {name = \"3\"}]\n" +
                             "known = 8\n" + farm_rows("tolerance = 2"));
    CHECK(study.tables.at(1).columns.size() == 3);
    CHECK(study.tables.at(1).rows.at(0).known.size() == 3);
    CHECK(study.tables.at(1).rows.at(0).tolerances.size() == 3);
}

TEST_CASE("columns or rows that are not tables give one error only") {
    auto said = [](const std::string& text) {
        try {
            farm_study(text);
        } catch (const RefusedInput& refused) {
            return std::string(refused.what());
        }
        return std::string("nothing");
    };
    const std::string rows = farm_rows("known = [1, 2, 3]"), form = "expected a list of tables";
    for (const std::string& text : {farm_head + "columns = [1, 2]\n" + rows, farm_head + "columns = []\n" + rows,
                                    farm_head + farm_columns + "rows = [1]\n"}) {
        const std::string all = said(text);
        CAPTURE(all);
        CHECK(all.find(form) != std::string::npos);
        CHECK(all.find("error:") == all.rfind("error:"));
    }
    const std::string all = said(farm_head + rows);
    CHECK(all.find("the table lacks columns or rows") != std::string::npos);
    CHECK(all.find("error:") == all.rfind("error:"));
}

TEST_CASE("a negative tolerance is refused") {
    for (const char* tolerance : {"-1", "\"-3 %\"", "\"2 - known\""})
        check_farm_refused(farm_head + farm_columns + farm_rows(std::string("known = 8, tolerance = ") + tolerance),
                           "the tolerance is -");
    for (const char* tolerance : {"\"\"", "\"%\""})
        check_farm_refused(farm_head + farm_columns + farm_rows(std::string("known = 8, tolerance = ") + tolerance),
                           "expected a number or an expression");
    CHECK_FALSE(farm_study(farm_head + farm_columns + farm_rows("known = 8, tolerance = [1, nan]"))
                    .tables.at(0)
                    .rows.at(0)
                    .tolerances.at(1)
                    .amount);
}

TEST_CASE("keys that cannot be combined with tables are refused") {
    const std::string table = farm_columns + farm_rows("");
    check_farm_refused("where = \"slaves > 0\"\n" + farm_head + table, ":1:9: error: \"where\" selects combinations");
    check_farm_refused(farm_head + table + "[search]\nminimise = \"time\"\n",
                       ":7:1: error: a study with [search] cannot have [[table]]");
    check_farm_refused(farm_head + "against = \"databook\"\n" + table, ":5:11: error: \"databook\" is too long");
    CHECK(farm_study(farm_head + "against = \"(4.9) ä\"\n" + table).tables.at(0).against == "(4.9) ä");
}

TEST_CASE("a figure may be a measure of the study or a row above") {
    const Comparison table = farm_table(
        farm_study(farm_head + "columns = [{name = \"two\", set = {slaves = 2}}]\n" +
                   "rows = [{name = \"least\", figure = \"min(t.busy)\"}, {name = \"most\", figure = \"max(t.busy)\"}, "
                   "{name = \"apart\", figure = \"most - least\"}]\n"));
    CHECK(table.cells.at(0).simulated == 20);
    CHECK(table.cells.at(1).simulated == 50);
    CHECK(table.cells.at(2).simulated == 30);
}

TEST_CASE("the cell of a run that did not complete has no figure") {
    const Comparison table = farm_table(farm_study(farm_head + farm_columns + farm_rows("known = 8, tolerance = 1")));
    CHECK(table.cells.at(0).simulated == 8);
    CHECK(table.cells.at(0).within_tolerance());
    CHECK(std::isnan(table.cells.at(1).simulated));
    CHECK_FALSE(table.cells.at(1).within_tolerance());
    CHECK(table.notes == "-: the run with slaves = 1 has no figure: deadlock\n");
    const std::string printed = print_comparison(table), row = printed.substr(printed.find("\na "));
    CHECK(row.find(" -       8!") != std::string::npos);
}
