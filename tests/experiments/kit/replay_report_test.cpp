// A replay's document for machines.

#include "experiments/kit/replay_report.hpp"

#include <boost/json.hpp>
#include <doctest/doctest.h>

using namespace placedpar;

TEST_CASE("a claim of two bounds has both in the document, one of one bound has no other") {
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
