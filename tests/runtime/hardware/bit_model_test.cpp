// Tests the bit model in cases that can be computed by hand. At 20 Mbit/s a bit lasts 50 ns and a byte 550 ns. The
// acknowledge begins 260 ns after the start of its byte, and the next byte 300 ns after the start of the acknowledge.

#include "bit_model.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <cstdint>
#include <vector>

using namespace placedpar;
using namespace placedpar::test;
using Nanoseconds = std::vector<std::int64_t>;

TEST_CASE("bit model: a receiver that takes fewer bytes than the sender gives leaves the next byte waiting") {
    Traffic traffic{.messages = {}, .given = {{0, 3}}, .taken = {{0, 2}, {890, 1}}};
    BitModel model({}, {traffic, {}});
    auto course = model.run_until_quiet(10'000)[0];
    CHECK(course.input_ended == Nanoseconds{1110, 2000}); // 560 + 550; 890 later the third byte, which waits already
    CHECK(model.byte_waited(0) == Nanoseconds{1670});     // 2 * 560 + 550
    CHECK(course.output_ended == Nanoseconds{2100});      // the acknowledge is asked for at 2000
    CHECK(model.packets().back() == BitModel::Packet{2000, 1, true, false});
}

TEST_CASE("bit model: a receiver that takes more bytes than the sender gives waits for the next transfer") {
    Traffic traffic{.messages = {}, .given = {{0, 1}, {640, 3}}, .taken = {{0, 2}, {0, 2}}};
    auto course = BitModel({}, {traffic, {}}).run_until_quiet(10'000)[0];
    CHECK(course.output_ended == Nanoseconds{360, 1000 + 2 * 560 + 360}); // 260 + 100 after the last byte's start
    CHECK(course.input_ended == Nanoseconds{1550, 1000 + 2 * 560 + 550});
}

TEST_CASE("bit model: an alternation sees the first byte that the receiver has not asked for, also within a transfer") {
    Traffic traffic{.messages = {}, .given = {{0, 3}}, .taken = {{0, 1}, {0, 2, true}}};
    BitModel model({}, {traffic, {}});
    auto course = model.run_until_quiet(10'000)[0];
    CHECK(model.byte_waited(0) == Nanoseconds{560 + 550});
    CHECK(course.input_ended == Nanoseconds{550, 1110 + 300 + 550});
    CHECK(course.output_ended == Nanoseconds{1110 + 300 + 260 + 100});
    CHECK(!model.byte_waits(0));
}

TEST_CASE("bit model: the rest of a transfer continues after the other end has finished its own") {
    Traffic gives_more{.messages = {}, .given = {{0, 3}}, .taken = {{0, 1}}};
    BitModel model({}, {gives_more, {}});
    auto course = model.run_until_quiet(10'000)[0];
    CHECK(course.output_ended.empty());
    CHECK(course.input_ended == Nanoseconds{550});
    CHECK(model.bytes_acknowledged(0) == 1);
    CHECK(model.bytes_arrived(0) == 2);
    CHECK(model.byte_waits(0));
    Traffic takes_more{.messages = {}, .given = {{0, 1}}, .taken = {{0, 3}}};
    course = BitModel({}, {Traffic{}, takes_more}).run_until_quiet(10'000)[1];
    CHECK(course.output_ended == Nanoseconds{360});
    CHECK(course.input_ended.empty());
}

TEST_CASE("bit model: a copy continues with other faults than the model") {
    Traffic traffic{.messages = {{0, 0, {3}}}, .given = {}, .taken = {}};
    BitModel model({}, {traffic, {}});
    model.run_until(559); // the second byte has yet to begin
    BitModel broken = model;
    broken.suffer({{.from = std::chrono::nanoseconds{560}, .wire_from_b = false}});
    CHECK(broken.run_until_quiet(10'000)[0] == Course{});
    CHECK(broken.packets().back() == BitModel::Packet{560, 0, false, true});
    CHECK(model.run_until_quiet(10'000)[0] == Course{{2 * 560 + 360}, {2 * 560 + 550}});
}
