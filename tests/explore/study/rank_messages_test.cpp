#include "explore/study/rank_messages.hpp"

#include <doctest/doctest.h>

#include <limits>

using namespace placedpar;

TEST_CASE("a message carries a run and its outcome without loss") {
    RankMessage sent{
        RankMessage::Kind::ended, "",
        StudyRun{{{"slaves", "3"}, {"t[0].name", "\"a, \\\"b\\\"\""}}, std::numeric_limits<std::uint64_t>::max()},
        StudyOutcome{.ended = "completed",
                     .time = Time::max(),
                     .fingerprint = 0xfedcba9876543210,
                     .netlist_hash = std::numeric_limits<std::uint64_t>::max(),
                     .refused = "mine.cfs:1:2: error: \u00b5\n",
                     .figures = {{"time", {0.1 + 0.2, "ms"}}, {"t[0].busy", {1e-300, "%"}}}}};
    RankMessage came = rank_message_from(text_of(sent));
    CHECK(came.kind == sent.kind);
    REQUIRE(came.run);
    CHECK(*came.run == *sent.run);
    REQUIRE(came.outcome);
    CHECK(came.outcome->ended == sent.outcome->ended);
    CHECK(came.outcome->time == sent.outcome->time);
    CHECK(came.outcome->fingerprint == sent.outcome->fingerprint);
    CHECK(came.outcome->netlist_hash == sent.outcome->netlist_hash);
    CHECK(came.outcome->refused == sent.outcome->refused);
    REQUIRE(came.outcome->figures.size() == 2);
    CHECK(came.outcome->figures.at("time").value == 0.1 + 0.2);
    CHECK(came.outcome->figures.at("t[0].busy").value == 1e-300);
    CHECK(came.outcome->figures.at("t[0].busy").unit == "%");
}

TEST_CASE("a digest is the same for the same texts, options and version, whatever the files are called") {
    StudySource source{"a.cfs", {{"a.cfs", "val n 1;"}, {"b.inc", "/* */"}}, "{}"}, moved = source, other = source;
    moved.netlist = moved.texts[0].first = "/elsewhere/a.cfs";
    CHECK(digest_of(moved) == digest_of(source));
    other.texts[0].second = "val n 2;";
    CHECK(digest_of(other) != digest_of(source));
    other = source;
    other.options = "{\"until_ps\":1}";
    CHECK(digest_of(other) != digest_of(source));
    other.texts = {{"a.cfs", "val n 1;/"}, {"b.inc", "* */"}};
    CHECK(digest_of(other) != digest_of(source));
}
