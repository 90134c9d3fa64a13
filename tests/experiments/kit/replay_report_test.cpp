// Tests the JSON document of a replay.

#include "experiments/kit/replay_report.hpp"

#include <boost/json.hpp>
#include <doctest/doctest.h>

using namespace placedpar;

TEST_CASE("in the document a claim has exactly its one or two bounds") {
    Comparison comparison{.name = "shares", .against = "claim"};
    comparison.cells = {cell_of("share", "of two", "", 0.67, 0.7, {}, 2),
                        cell_of("share", "of one", "", 0.5, 0.7, {}, 2)};
    comparison.cells[0].reference_to = 0.99;
    boost::json::array cells =
        replay_json({.comparisons = {comparison}}, "pga-1", 1, "replay pga-1").at("cells").as_array();
    CHECK(cells.at(0).at("claim") == 0.67);
    CHECK(cells.at(0).at("claim_to") == 0.99);
    CHECK(cells.at(0).at("thesis").is_null());
    CHECK(cells.at(1).at("claim") == 0.5);
    CHECK(!cells.at(1).as_object().contains("claim_to"));
}

namespace {

Replay of_two_tables() {
    Comparison second{.name = "second", .cells = {plain_cell("y", "b", "", 5, 0)}, .against = "known", .judged = true};
    return {.comparisons = {{.name = "first", .cells = {judged_cell("x", "a", "ms", 10, 11, 0.5, 1)}}, second},
            .constants = "k  read off\n",
            .fingerprint = 0xabc};
}

} // namespace

TEST_CASE("the printed replay has tables, constants, fingerprint, and the verdict at the end") {
    Replay replay = of_two_tables();
    replay.constant_table = {{"link", "bits of a byte", 11, "bit", {}, "databook"},
                             {"link", "bits of an acknowledge", 2, "bit", {}, "databook"},
                             {"processor", "clock", 20e6, "Hz", {}, "databook"}};
    const std::string text = print_replay(replay);
    CHECK(text.starts_with("first\n"));
    CHECK(text.find("\n\nsecond\n") != text.npos);
    CHECK(text.find("\nlink\n  bits of a byte") != text.npos);
    CHECK(text.find("\n  bits of an acknowledge") != text.npos); // the group's name occurs once
    CHECK(text.find("\nprocessor\n  clock ") != text.npos);
    CHECK(text.find(" 2e+07 Hz ") != text.npos);
    CHECK(text.find("\n\ncells judged against the thesis: 1; against own figures: 0; not judged: 1\n\n") != text.npos);
    CHECK(text.ends_with("k  read off\nfingerprint: 0000000000000abc\na cell misses its tolerance\n"));
}

TEST_CASE("the JSON document has the first table as its reading, and the others with their verdicts") {
    boost::json::object json = replay_json(of_two_tables(), "pga-1", 7, "replay pga-1 --seed 7");
    CHECK(json.at("experiment") == "pga-1");
    CHECK(json.at("seed") == 7);
    CHECK(json.at("fingerprint") == "0000000000000abc");
    CHECK(json.at("reading") == "first");
    CHECK(json.at("within_tolerance") == false);
    const boost::json::object& cell = json.at("cells").at(0).as_object();
    CHECK(cell.at("thesis") == 10.0);
    CHECK(cell.at("error_percent") == 10.0);
    CHECK(cell.at("tolerance_percent") == 5.0);
    CHECK(cell.at("tolerance") == 0.5);
    CHECK(cell.at("origin") == "outcome");
    CHECK(cell.at("judged_by") == "thesis");
    CHECK(json.at("judged").at("thesis") == 1);
    CHECK(json.at("judged").at("not_judged") == 1);
    for (const char* of_others : {"at_least", "at_most", "source", "known", "interval"})
        CHECK_FALSE(cell.contains(of_others));
    REQUIRE(json.at("other_readings").as_array().size() == 1);
    const boost::json::object& other = json.at("other_readings").at(0).as_object();
    CHECK(other.at("judged") == true);
    CHECK(other.at("within_tolerance") == true);
    CHECK(other.at("cells").at(0).at("known").is_null());
    CHECK_FALSE(json.contains("constants"));
}
