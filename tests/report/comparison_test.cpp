#include "report/comparison.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace placedpar;

namespace {

Cell cell(const char* row, const char* column, const char* unit, std::optional<double> reference, double simulated,
          std::optional<double> tolerance = {}, int decimals = 2) {
    return {.row = row,
            .column = column,
            .unit = unit,
            .reference = reference,
            .simulated = simulated,
            .tolerance = tolerance,
            .decimals = decimals};
}

} // namespace

TEST_CASE("a comparison is printed with its decimals, its marks, and the error in the unit of the tolerance") {
    Comparison comparison{.name = "name", .notes = "notes\n"};
    comparison.cells = {cell("spool", "a", "in", 0.2741, 0.27406, 2e-4, 5),
                        cell("spool", "b", "in", 0.2688, 0.27, 2e-4, 5), cell("flow", "a", "", 50, 49.5),
                        cell("flow", "b", "", {}, 1)};
    comparison.cells[2].tolerance_percent = 0.5;
    CHECK(print_comparison(comparison) == "name\n"
                                          "                                   a                         b\n"
                                          "            simulat.  thesis   error  simulat.  thesis   error  tolerance\n"
                                          "spool [in]  0.27406  0.2741 -.00004   0.27000  0.2688 +.00120!  0.0002\n"
                                          "flow          49.50      50   -1.0%!     1.00                   0.5%\n"
                                          "notes\n");
}

TEST_CASE("a row with new columns begins a new table") {
    Comparison comparison{.name = "name", .against = "known"};
    comparison.cells = {cell("x", "a", "", 1, 1), cell("x", "b", "", 2, 2), cell("y", "b", "", 3, 3),
                        cell("z", "c", "", 0, -1e-9, 1e-3)};
    CHECK(print_comparison(comparison) == "name\n"
                                          "                             a                         b\n"
                                          "      simulat.   known   error  simulat.   known   error\n"
                                          "x        1.00       1   +0.0%      2.00       2   +0.0%\n"
                                          "y                                  3.00       3   +0.0%\n"
                                          "                             c\n"
                                          "      simulat.   known   error  tolerance\n"
                                          "z        0.00       0       0   0.001\n");
}

TEST_CASE("a row shows each tolerance once, and none if bounds judge") {
    Comparison comparison{.name = "name"};
    comparison.cells = {cell("x", "a", "", 1, 1, 0.1), cell("x", "b", "", 2, 2, 0.1), cell("x", "c", "", 3, 3, 25),
                        at_least(1, cell("y", "a", "", 1, 1, 0.1))};
    std::string printed = print_comparison(comparison);
    CHECK(printed.find("0   0.1, 25\n") != std::string::npos);
    CHECK(printed.find(">= 1\n") != std::string::npos);
}

TEST_CASE("a tolerance is in percent or in the unit, or absent; a missing figure meets no tolerance") {
    Cell judged = cell("x", "a", "", 100, 103);
    CHECK(judged.within_tolerance());
    judged.tolerance_percent = 2;
    CHECK_FALSE(judged.within_tolerance());
    judged.tolerance = 3;
    CHECK(judged.within_tolerance());
    judged.tolerance = 2.9;
    CHECK_FALSE(judged.within_tolerance());
    judged.reference = -50;
    CHECK(*judged.tolerance_in_percent() == doctest::Approx(5.8));
    judged.reference.reset();
    CHECK_FALSE(judged.tolerance_in_percent().has_value());
    CHECK_FALSE(judged.within_tolerance());
    Cell negative = cell("x", "a", "", -100, -103);
    CHECK(*negative.error_percent() == doctest::Approx(-3));
    negative.tolerance_percent = 2;
    CHECK_FALSE(negative.within_tolerance());
    CHECK(Comparison{.name = "", .cells = {cell("x", "a", "", 100, 1)}}.within_tolerance());
    CHECK_FALSE(Comparison{.name = "", .cells = {cell("x", "a", "", 1, 1), judged}}.within_tolerance());
}

TEST_CASE("a one-sided cell shows its bound instead of an error, and a mark if it misses the bound") {
    Comparison comparison{.name = "name"};
    comparison.cells = {cell("share", "a", "%", 65, 52, {}, 0), cell("share", "b", "%", 65, 72, {}, 0),
                        cell("error", "a", "%", {}, 10.4, {}, 1)};
    comparison.cells[0].at_least = comparison.cells[1].at_least = 55;
    comparison.cells[2].at_most = 10;
    CHECK(print_comparison(comparison) == "name\n"
                                          "                                  a                         b\n"
                                          "           simulat.  thesis   error  simulat.  thesis   error\n"
                                          "share [%]       52      65   >= 55!       72      65   >= 55\n"
                                          "error [%]     10.4           <= 10!\n");
    CHECK_FALSE(comparison.within_tolerance());
}

TEST_CASE("a column leaves out parts that are empty in all its cells, and has at least the width of its name") {
    Comparison comparison{.name = "name", .against = "known"};
    comparison.cells = {cell("x", "a", "", {}, 1), cell("x", "of a long name", "", {}, 2), cell("x", "c", "", 0, 3),
                        cell("x", "d", "", 4, 5),  cell("y", "a", "", {}, 10, 1),          cell("y", "d", "", {}, 6)};
    CHECK(print_comparison(comparison) == "name\n"
                                          "             a  of a long name                 c                         d\n"
                                          "      simulat.        simulat.  simulat.   known  simulat.   known   error\n"
                                          "x        1.00            2.00      3.00       0      5.00       4  +25.0%\n"
                                          "y       10.00!                                       6.00\n");
}

TEST_CASE("beside a claim no error in percent is printed, only the bound if it is judged") {
    Comparison comparison{.name = "name", .against = "claim"};
    comparison.cells = {cell("x", "a", "", 0.01, -0.02)};
    CHECK(print_comparison(comparison) == "name\n"
                                          "                     a\n"
                                          "      simulat.   claim\n"
                                          "x       -0.02    0.01\n");
    comparison.cells = {at_most(0.01, cell("x", "a", "", {}, 0.02))};
    CHECK(print_comparison(comparison) == "name\n"
                                          "                     a\n"
                                          "      simulat.   error\n"
                                          "x        0.02 <= 0.01!\n");
}

TEST_CASE("a claim of two bounds shows both without shifting other columns") {
    Comparison comparison{.name = "name", .against = "claim"};
    comparison.cells = {cell("x", "a", "", 0.67, 1), cell("x", "b", "", {}, 2), cell("y", "a", "", {}, -1234.5),
                        cell("y", "b", "", 3, 3, 0.25)};
    comparison.cells.front().reference_to = 0.99;
    CHECK(print_comparison(comparison) == "name\n"
                                          "                        a                         b\n"
                                          "       simulat.     claim  simulat.   claim   error  tolerance\n"
                                          "x         1.00 0.67-0.99      2.00\n"
                                          "y     -1234.50                3.00       3       0   0.25\n");
}

TEST_CASE("a cell is judged as its table says, unless it names another judge") {
    const Cell cell = judged_cell("x", "a", "", 1, 1, 1, 0);
    auto judge = [&](const char* against, const Cell& each) {
        return Comparison{.name = "", .against = against}.judge_of(each);
    };
    for (const char* word : {"thesis", "claim", "(4.9)", "eq. 6.2"})
        CHECK(judge(word, cell) == Judge::thesis);
    for (const char* word : {"publ.", "Poznan"})
        CHECK(judge(word, cell) == Judge::published);
    for (const char* word : {"known", "true", "other", "ideal", "impulse"})
        CHECK(judge(word, cell) == Judge::own);
    CHECK(judge("thesis", judged_by(Judge::own, cell)) == Judge::own);
    CHECK(judge("known", judged_by(Judge::thesis, cell)) == Judge::thesis);
}

TEST_CASE("cells are counted by their judge; cells of a table that does not decide are not judged") {
    Cell judged = judged_cell("x", "a", "", 1, 1, 1, 0), set = judged;
    set.origin = Origin::workload;
    const Cell shown = plain_cell("x", "b", "", 1, 0);
    Comparison first{.name = "first", .cells = {judged, set, judged_by(Judge::own, judged), shown}},
        published{.name = "second", .cells = {judged, shown}, .against = "publ.", .judged = true},
        reading{.name = "third", .cells = {judged, judged}};
    CHECK(print_judged(count_judged({first, reading})) ==
          "cells judged against the thesis: 2 (1 of them set constants); against own figures: 1; "
          "not judged: 3\n");
    CHECK(print_judged(count_judged({published, reading})) ==
          "cells judged against the thesis: 0; against published figures: 1; against own figures: 0; not judged: 3\n");
    CHECK(count_judged({first, published, reading}).published == 1);
}

TEST_CASE("the first table and tables marked as judged decide the verdict") {
    Comparison good{.name = "good"}, bad{.name = "bad", .cells = {at_most(1, plain_cell("x", "a", "", 2, 1))}};
    CHECK(are_within_tolerance({good, bad}));
    CHECK(print_verdict({good, bad}) == "every judged cell of the first reading is within its tolerance\n");
    CHECK_FALSE(are_within_tolerance({bad, good}));
    bad.judged = true;
    CHECK_FALSE(are_within_tolerance({good, bad}));
    CHECK(print_verdict({good, bad}) == "a cell misses its tolerance\n");
}

TEST_CASE("the fit covers outcomes with known figures, in the first cell's unit") {
    std::vector<Cell> cells{cell("a", "x", "ms", 10, 10.3), cell("a", "y", "ms", 10, 9.6), cell("a", "z", "ms", 0, 0),
                            cell("b", "x", "s", 1, 3), cell("c", "x", "ms", 1, 5)};
    cells.back().origin = Origin::calibrated;
    CHECK(print_fit(cells) == "outcomes: rms error 3.5 %, greatest -4.0 % (a, y)\n");
    CHECK(print_fit({cells.back()}).empty());
}

TEST_CASE("fitted and workload figures are marked, and a missing figure is a dash") {
    Comparison comparison{.name = "name", .against = "known"};
    comparison.cells = {cell("x", "a", "", 1, 2, 0.5), cell("y", "a", "", 1, 2, 0.5), cell("z", "a", "", 1, NAN, 0.5)};
    comparison.cells[0].origin = Origin::calibrated;
    comparison.cells[1].origin = Origin::workload;
    comparison.cells[0].source = "a handbook";
    CHECK(print_comparison(comparison) == "name\n"
                                          "                             a\n"
                                          "      simulat.   known   error  tolerance  source\n"
                                          "x        2.00       1   +1.00c  0.5        a handbook\n"
                                          "y        2.00       1   +1.00w  0.5\n"
                                          "z           -       1        !  0.5\n");
}

TEST_CASE("each origin has a letter, or words in a table that names origins") {
    Comparison comparison{.name = "name", .against = "known"};
    for (Origin origin : every_origin) {
        comparison.add(cell(name_of(origin), "a", "", 1, 2, 2));
        comparison.cells.back().origin = origin;
    }
    CHECK(print_comparison(comparison) == "name\n"
                                          "                                      a\n"
                                          "               simulat.   known   error  tolerance\n"
                                          "outcome           2.00       1   +1.00   2\n"
                                          "calibrated        2.00       1   +1.00c  2\n"
                                          "workload          2.00       1   +1.00w  2\n"
                                          "fitted            2.00       1   +1.00f  2\n"
                                          "constant          2.00       1   +1.00k  2\n");
    comparison.names_origins = true;
    comparison.cells.resize(2);
    comparison.cells[1].tolerance = 0.5;
    comparison.cells[0].source = "a handbook";
    CHECK(print_comparison(comparison) == "name\n"
                                          "                                      a\n"
                                          "               simulat.   known   error  tolerance  mark        source\n"
                                          "outcome           2.00       1   +1.00   2          outcome     a handbook\n"
                                          "calibrated        2.00       1   +1.00!  0.5        calibrated\n");
}

TEST_CASE("tables are judged only if a deciding table has a bound") {
    const Comparison shown{.name = "shown", .cells = {plain_cell("x", "a", "", 2, 1)}};
    Comparison bounded{.name = "bounded", .cells = {at_most(1, plain_cell("x", "a", "", 2, 1))}};
    CHECK(is_any_judged({bounded, shown}));
    CHECK_FALSE(is_any_judged({shown, bounded}));
    bounded.judged = true;
    CHECK(is_any_judged({shown, bounded}));
}

TEST_CASE("a cell between two bounds shows both") {
    Comparison comparison{.name = "name"};
    comparison.cells = {at_most(5, at_least(1, cell("x", "a", "", {}, 3)))};
    CHECK(print_comparison(comparison).find("3.00 >= 1, <= 5\n") != std::string::npos);
    CHECK(comparison.cells[0].within_tolerance());
}
