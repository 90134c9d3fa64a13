// Tests properties of the tables of every quick replay.

#include "tests/experiments/kit/replay_in_memory.hpp"

#include <doctest/doctest.h>

#include <set>
#include <string>
#include <utility>

using namespace placedpar;

TEST_CASE("no table has a figure twice, and each judged cell has a known figure or bound") {
    for (const char* name : {"table-2-6", "figure-2-3", "figures-2-8-2-9", "circuits", "links", "processor"}) {
        CAPTURE(name);
        const Replay replay = test::replay_named(name);
        CHECK(replay.within_tolerance());
        CHECK(is_any_judged(replay.comparisons));
        std::set<std::string> tables;
        for (const Comparison& table : replay.comparisons) {
            CAPTURE(table.name);
            CHECK(tables.insert(table.name).second);
            CHECK(table.against.size() <= 7); // the column's width
            std::set<std::pair<std::string, std::string>> places;
            for (const Cell& cell : table.cells) {
                CAPTURE(cell.row);
                CAPTURE(cell.column);
                CHECK(places.emplace(cell.row, cell.column).second);
                if (cell.is_judged())
                    CHECK((cell.reference || cell.at_least || cell.at_most));
            }
        }
        for (const NamedPlot& each : replay.plots)
            for (const Panel& panel : each.plot.panels)
                for (const Series& series : panel.series)
                    CHECK_FALSE_MESSAGE(series.points.empty(), panel.title << ": " << series.name);
    }
}

TEST_CASE("with one seed a study has all its tables and curves, and no claim is decided") {
    for (const char* name : {"pga-1", "pga-2", "encoding", "falling-error"}) {
        CAPTURE(name);
        const Replay replay = test::replay_named(name, 1);
        std::size_t claims = 0;
        for (const Comparison& table : replay.comparisons) {
            CAPTURE(table.name);
            REQUIRE_FALSE(table.cells.empty());
            if (table.against != "claim")
                continue;
            ++claims;
            CHECK(table.within_tolerance());
            CHECK(table.notes.find("undecided") != std::string::npos);
            CHECK(table.notes.find(": holds") == std::string::npos);
            CHECK(table.notes.find("does not hold") == std::string::npos);
        }
        CHECK((claims > 0) == (std::string(name) != "encoding"));
        for (const NamedPlot& each : replay.plots)
            for (const Panel& panel : each.plot.panels)
                for (const Series& series : panel.series)
                    CHECK_FALSE_MESSAGE(series.points.empty(), panel.title << ": " << series.name);
    }
}

TEST_CASE("a replay of the same seed has the same fingerprint") {
    for (const char* name : {"figure-2-3", "links"})
        CHECK(test::replay_named(name).fingerprint == test::replay_named(name).fingerprint);
}
