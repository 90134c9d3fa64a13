// Tests which tables decide a replay: misses must not pass, and tables that only inform must not fail it.

#include "experiments/kit/experiment.hpp"
#include "experiments/kit/replay_report.hpp"

#include <boost/json.hpp>
#include <doctest/doctest.h>

#include <limits>
#include <optional>
#include <string>
#include <vector>

using namespace placedpar;

namespace {

constexpr double no_figure = std::numeric_limits<double>::quiet_NaN();

Comparison table_with(std::vector<Cell> cells, bool judged = false) {
    return {.name = "table", .cells = std::move(cells), .judged = judged};
}

Cell right_cell() { return judged_cell("right", "a", "ms", 10, 10.5, 0.5, 1); }
Cell wrong_cell() { return judged_cell("wrong", "a", "ms", 10, 10.6, 0.5, 1); }

bool passes(std::vector<Comparison> tables) { return replay_of(std::move(tables), {}).within_tolerance(); }

} // namespace

TEST_CASE("one cell that misses fails the replay if its table is the first or is judged") {
    CHECK(passes({table_with({right_cell()})}));
    CHECK_FALSE(passes({table_with({right_cell(), wrong_cell()})}));
    CHECK_FALSE(passes({table_with({right_cell()}), table_with({wrong_cell()}, true)}));
    CHECK(passes({table_with({right_cell()}), table_with({wrong_cell()})}));
    CHECK_FALSE(passes({table_with({wrong_cell()}), table_with({right_cell()}, true)}));
}

TEST_CASE("a tolerance includes its end, on both sides") {
    for (double value : {9.5, 10.5})
        CHECK(passes({table_with({judged_cell("x", "a", "", 10, value, 0.5, 1)})}));
    for (double value : {9.4375, 10.5625})
        CHECK_FALSE(passes({table_with({judged_cell("x", "a", "", 10, value, 0.5, 1)})}));
    CHECK(passes({table_with({judged_cell("x", "a", "", 0, 0, 0, 0)})})); // an exact count
    CHECK_FALSE(passes({table_with({judged_cell("x", "a", "", 0, 1, 0, 0)})}));
}

TEST_CASE("a figure that does not exist meets no tolerance and no bound") {
    CHECK_FALSE(passes({table_with({judged_cell("x", "a", "", 10, no_figure, 1e9, 1)})}));
    CHECK_FALSE(passes({table_with({at_least(-1e9, plain_cell("x", "a", "", no_figure, 1))})}));
    CHECK_FALSE(passes({table_with({at_most(1e9, plain_cell("x", "a", "", no_figure, 1))})}));
    Cell percent = compared_cell("x", "a", "", 10, no_figure, 1);
    percent.tolerance_percent = 1e9;
    CHECK_FALSE(passes({table_with({percent})}));
    CHECK(passes({table_with({plain_cell("x", "a", "", no_figure, 1)})})); // it is only shown
}

TEST_CASE("a share misses its bound only with its whole interval: 95 of 100 seeds are not surely fewer than 97 %") {
    CHECK(passes({table_with({at_least(97, share_cell("x", "a", 95, 100))})})); // 88.7 to 98.4 %
    CHECK_FALSE(passes({table_with({at_least(97, share_cell("x", "a", 88, 100))})}));
    CHECK(passes({table_with({at_most(1, share_cell("x", "a", 2, 60))})}));
    CHECK_FALSE(passes({table_with({at_most(1, share_cell("x", "a", 6, 60))})})); // at least 3.8 %
    CHECK(passes({table_with({at_least(100, share_cell("x", "a", 0, 0))})}));     // no run, no verdict
}

TEST_CASE("the printed replay ends with the verdict of its tables") {
    const auto verdict = [](std::vector<Comparison> tables) {
        const std::string text = print_replay(replay_of(std::move(tables), {}));
        return text.substr(text.rfind('\n', text.size() - 2) + 1);
    };
    const std::string missed = verdict({table_with({wrong_cell()}, true)}),
                      met = verdict({table_with({right_cell()}, true)});
    CHECK(missed.find("misses") != std::string::npos);
    CHECK(met.find("misses") == std::string::npos);
    CHECK(met.find("within") != std::string::npos);
    CHECK(verdict({table_with({plain_cell("x", "a", "", 1, 0)})}) != met); // nothing is judged
}

TEST_CASE("the JSON document says the same as the verdict, table by table") {
    const Replay replay =
        replay_of({table_with({right_cell()}), table_with({wrong_cell()}), table_with({wrong_cell()}, true)}, {});
    const boost::json::object json = replay_json(replay, "x", 1, "replay x");
    CHECK(json.at("within_tolerance") == false);
    const boost::json::array& others = json.at("other_readings").as_array();
    REQUIRE(others.size() == 2);
    CHECK(others[0].at("judged") == false);
    CHECK(others[0].at("within_tolerance") == false);
    CHECK(others[1].at("judged") == true);
    CHECK(json.at("judged").at("not_judged") == 1); // the cell of the table that the verdict ignores
}

TEST_CASE("the JSON document has a cell's bounds, interval, source and judge") {
    Cell cell = at_most(5, at_least(2, share_cell("x", "a", 3, 100)));
    cell.source = "databook, table 8.1";
    cell.judge = Judge::own;
    const boost::json::object json = replay_json(replay_of({table_with({cell})}, {}), "x", 1, "replay x");
    const boost::json::object& out = json.at("cells").at(0).as_object();
    CHECK(out.at("at_least") == 2.0);
    CHECK(out.at("at_most") == 5.0);
    CHECK(out.at("source") == "databook, table 8.1");
    CHECK(out.at("judged_by") == "own");
    CHECK(out.at("thesis").is_null());
    CHECK(out.at("error_percent").is_null());
    // Clopper and Pearson: 3 of 100
    CHECK(out.at("interval").at(0).as_double() == doctest::Approx(0.6230).epsilon(1e-3));
    CHECK(out.at("interval").at(1).as_double() == doctest::Approx(8.5176).epsilon(1e-3));
}

TEST_CASE("the JSON document has the constants of the machine with their marks and sources") {
    Replay replay = replay_of({table_with({right_cell()})}, {});
    replay.constant_table = {
        {"link", "bits of a byte", 11, "bit", hardware::Provenance::published, "databook"},
        {"router", "a packet", 4500, "cycles", hardware::Provenance::calibrated, "160 s with 71 workers"}};
    const boost::json::object json = replay_json(replay, "x", 1, "replay x");
    const boost::json::array& constants = json.at("constants").as_array();
    REQUIRE(constants.size() == 2);
    CHECK(constants[0].at("group") == "link");
    CHECK(constants[0].at("value") == 11.0);
    CHECK(constants[0].at("mark") == "published");
    CHECK(constants[1].at("name") == "a packet");
    CHECK(constants[1].at("mark") == "calibrated");
    CHECK(constants[1].at("source") == "160 s with 71 workers");
}

TEST_CASE("a fingerprint is that of the tables in their order, not of the plots") {
    const Comparison one = table_with({right_cell()}), other = table_with({wrong_cell()});
    CHECK(replay_of({one, other}, {}).fingerprint != replay_of({other, one}, {}).fingerprint);
    const std::vector<NamedPlot> plots{{"plot", {"title", {}}}};
    CHECK(replay_of({one}, plots).fingerprint == replay_of({one}, {}).fingerprint);
    CHECK(replay_of({one}, plots).plots.size() == 1);
}
