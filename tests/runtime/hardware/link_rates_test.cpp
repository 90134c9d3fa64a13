// Tests links against published figures.

#include "runtime/hardware/instructions.hpp"
#include "runtime/hardware/link.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/parallel.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace placedpar;
using namespace placedpar::hardware;

namespace {

struct Block {
    std::uint32_t bytes;
    WireForm wire_form() const { return WireForm(bytes); }
};

/// Returns the data rate of a link in Kbyte/s, in one direction or as the sum of both.
double rate(const LinkTiming& timing, bool both_ways) {
    constexpr std::uint32_t bytes = 100'000;
    Simulation simulation;
    Link& link = simulation.add<Link>(timing);
    Channel<Block> there("there", link.from_a_to_b()), back("back", link.from_b_to_a());
    for (Channel<Block>* channel : {&there, &back})
        if (channel == &there || both_ways) {
            simulation.process("sender", [channel] { channel->out().output(Block{bytes}); });
            simulation.process("receiver", [channel] { channel->in().input(); });
        }
    double seconds = in_milliseconds(simulation.run().time) * 1e-3;
    return (both_ways ? 2 : 1) * bytes / seconds * 1e-3;
}

void check_within(double percent, double value, double published) {
    CAPTURE(value);
    CAPTURE(published);
    CHECK(std::abs(value - published) <= percent / 100 * published);
}

/// Returns half the round trip of a message of `words` words in microseconds. Two high-priority processes exchange it,
/// as measured on real T805s.
double half_round_trip(std::uint32_t words) {
    constexpr int rounds = 10;
    Simulation simulation;
    Processor& near = simulation.add<Processor>("near", 20'000'000, instructions::toolset_channel_call);
    Processor& far = simulation.add<Processor>("far", 20'000'000, instructions::toolset_channel_call);
    Link& link = simulation.add<Link>();
    Channel<Block> ping("ping", link.from_a_to_b()), pong("pong", link.from_b_to_a());
    Time took{};
    simulation.process(
        "near",
        [&] {
            Time start = now();
            for (int i = 0; i < rounds; ++i)
                ping.out().output(Block{4 * words}), pong.in().input();
            took = now() - start;
        },
        &near, Priority::high);
    simulation.process(
        "far",
        [&] {
            for (int i = 0; i < rounds; ++i)
                ping.in().input(), pong.out().output(Block{4 * words});
        },
        &far, Priority::high);
    CHECK(simulation.run().ending == Ending::completed);
    return in_milliseconds(took) * 1000 / (2 * rounds);
}

} // namespace

TEST_CASE("links have the data rates of table 8.1 of the databook at 5, 10 and 20 Mbit/s, one way and both ways") {
    struct Row {
        std::int64_t bits_per_second;
        double one_way, both_ways;
    };
    for (Row row : {Row{5'000'000, 450, 670}, Row{10'000'000, 910, 1250}, Row{20'000'000, 1740, 2350}}) {
        LinkTiming timing;
        timing.bits_per_second = row.bits_per_second;
        check_within(3, rate(timing, false), row.one_way);
        check_within(3, rate(timing, true), row.both_ways);
    }
}

TEST_CASE("a link without overlapped acknowledges carries about 0.8 Mbyte/s") {
    LinkTiming timing;
    timing.overlapped_acknowledge = false;
    CHECK(std::abs(rate(timing, false) - 800) <= 50); // published with one digit
}

TEST_CASE("a link through three C004s in series carries the 0.923 to 0.930 Mbyte/s measured in Poznan") {
    LinkTiming timing;
    timing.wire_delay = duration_of(3 * 175, 100 * timing.bits_per_second); // the manual: 1.75 bits each way
    check_within(1, rate(timing, false), (923 + 930) / 2.0);
}

TEST_CASE("a link through one C004 carries 1.33 Mbyte/s, and without it 1.75") {
    LinkTiming timing;
    check_within(3, rate(timing, false), 1750);
    timing.wire_delay = duration_of(175, 100 * timing.bits_per_second);
    check_within(3, rate(timing, false), 1330);
}

TEST_CASE("a ping-pong of n words takes the 11.0 + 2.25 n us measured on T805s") {
    double one = half_round_trip(1), thousand = half_round_trip(1000);
    double slope = (thousand - one) / 999, intercept = one - slope;
    check_within(1, slope, 2.25);
    CHECK(std::abs(intercept - 11.0) <= 0.2);
}
