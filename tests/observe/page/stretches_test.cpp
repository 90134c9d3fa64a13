#include "observe/page/stretches.hpp"

#include <doctest/doctest.h>

using namespace placedpar;
using page::BothEnds;
using page::PackedStretch;
using page::Stretches;

namespace {

PackedStretch ten_bytes(int begin, int end) { return {Time{begin}, Time{end}, 3, std::string(10, 'x')}; }

Slice working(std::size_t track, int begin, int end) {
    return {track, Activity::computing, Time{begin}, Time{end}, false, "work"};
}

/// Track 0 computes in many steps of one picosecond; track 1 computes once, for the same total time.
Stretches steps_and_a_long_one(const Tracks& tracks, int steps, const page::Room& room) {
    Stretches stretches(tracks, Time{}, room);
    for (int i = 0; i < steps; ++i)
        stretches.add(working(0, i, i + 1));
    stretches.add(working(1, 0, steps));
    stretches.finish();
    return stretches;
}

} // namespace

TEST_CASE("if there are too many stretches, the first and last are kept") {
    BothEnds ends(25);
    for (int i = 0; i < 4; ++i)
        ends.add(ten_bytes(i, i + 1));
    CHECK(ends.left_out() == 0);
    CHECK_FALSE(ends.lost());
    ends.add(ten_bytes(4, 5));
    ends.add(ten_bytes(5, 6));
    CHECK(ends.left_out() == 6);
    REQUIRE(ends.lost());
    CHECK(ends.lost()->begin == Time{2});
    CHECK(ends.lost()->end == Time{4});
    std::vector<Time> begins;
    for (const PackedStretch* each : ends.all())
        begins.push_back(each->begin);
    CHECK(begins == std::vector{Time{0}, Time{1}, Time{4}, Time{5}});
}

TEST_CASE("slices longer than a stretch are in another row, and each stretch states its beginning and end") {
    Network network;
    Tracks tracks(network);
    Stretches stretches = steps_and_a_long_one(tracks, 10, {.entries_of_stretch = 4});
    std::vector<std::pair<int, int>> periods;
    std::size_t entries = 0;
    for (const PackedStretch* each : stretches.all()) {
        periods.emplace_back(each->begin.count(), each->end.count());
        entries += each->entries;
    }
    CHECK(periods == std::vector<std::pair<int, int>>{{0, 4}, {4, 8}, {8, 10}, {0, 10}});
    CHECK(entries == 11);
    CHECK_FALSE(stretches.are_deflated());
}

TEST_CASE("the stretches of a long run are compressed, including earlier ones") {
    Network network;
    Tracks tracks(network);
    Stretches plain = steps_and_a_long_one(tracks, 400, {.entries_of_stretch = 100, .entries_at_once = 401});
    Stretches packed = steps_and_a_long_one(tracks, 400, {.entries_of_stretch = 100, .entries_at_once = 400});
    CHECK_FALSE(plain.are_deflated());
    CHECK(packed.are_deflated());
    REQUIRE(packed.all().size() == plain.all().size());
    for (std::size_t i = 0; i < 4; ++i)
        CHECK(packed.all()[i]->bytes.size() < plain.all()[i]->bytes.size() / 4);
}

TEST_CASE("stretches without room are reported as left out") {
    Network network;
    Tracks tracks(network);
    Stretches stretches = steps_and_a_long_one(tracks, 400, {.entries_of_stretch = 10, .bytes_of_each_end = 500});
    REQUIRE(stretches.lost());
    std::size_t bytes = 0, entries = 0;
    for (const PackedStretch* each : stretches.all()) {
        bytes += each->bytes.size();
        entries += each->entries;
        CHECK((each->end <= stretches.lost()->begin || each->begin >= stretches.lost()->end || each->entries == 1));
    }
    CHECK(bytes < 1200);
    CHECK(entries + stretches.left_out() == 401);
}

TEST_CASE("a stretch has a known encoding") {
    page::Stretch stretch(Time{100});
    stretch.add(Slice{2, Activity::inputting, Time{110}, Time{115}, true, "", 0, {{"c", "p"}}});
    stretch.add(Slice{1, Activity::computing, Time{100}, Time{300}, false, "w"});
    std::string channel = "c";
    stretch.add(MessageArrow{channel, 1, 2, Time{105}, Time{110}});
    PackedStretch packed = stretch.pack();
    CHECK(packed.end == Time{300});
    CHECK(packed.entries == 3);
    CHECK(stretch.begin() == Time{300});
    CHECK(stretch.entries() == 0);
    std::string texts = R"(["","c\tp","w","c"])";
    std::string computes(1, static_cast<char>(Activity::computing)),
        inputs(1, static_cast<char>(Activity::inputting) + 16);
    CHECK(packed.bytes == std::string(1, static_cast<char>(texts.size())) + texts + // texts
                              std::string("\2\1\1\2\1", 5) +    // tracks 1 and 2 have one slice each
                              std::string("\0\12\310\1\5", 5) + // gaps; lengths
                              computes + inputs + "\2\1" +      // notes
                              "\1\1\2\5\5\3");                  // the message
}
