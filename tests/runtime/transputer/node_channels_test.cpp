// Tests channels of emulated transputers that are links: counts that do not agree, directions, ALT, interrupts, and
// engines that are reset.

#include "node_world.hpp"
#include "tests/sanitized.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

using namespace placedpar;
using namespace placedpar::test;
using transputer::assemble;
using transputer::Assembly;
using namespace std::chrono_literals;

namespace {

constexpr std::uint32_t there_out = 0x04, here_in = 0x14; ///< channels of link 1
constexpr std::uint32_t message_at = 0x900;

/// Returns instructions for a communication of bytes of the message_at.
std::string communication(const char* instruction, std::uint32_t channel, std::uint32_t from, std::uint32_t bytes) {
    return fmt::format("ldc #{:X}\nldc #{:X}\nldc {}\n{}\n", from_start(message_at + from), from_start(channel), bytes,
                       instruction);
}

/// Returns instructions that store a word at an offset.
std::string note_word(std::uint32_t offset, std::uint32_t value) {
    return fmt::format("ldc {}\nldc #{:X}\nstnl 0\n", value, from_start(offset));
}

/// Returns a delay of 4 cycles and more for each turn.
std::string delay_loop(std::uint32_t turns, const char* name) {
    return fmt::format("ldc {}\nstl 1\n{}: ldl 1\nadc -1\nstl 1\nldl 1\ncj {}x\nj {}\n{}x:\n", turns, name, name, name,
                       name);
}

/// Two nodes that are connected by their links 1.
struct LinkedPair {
    explicit LinkedPair(const std::string& a_program, const std::string& b_program) {
        for (const std::size_t i : {0u, 1u}) {
            nodes[i] = &world.node("n", {});
            programs[i] = assemble(i == 0 ? a_program : b_program, from_start(0x200));
            NodeWorld::put(*nodes[i], programs[i]);
            times[i].emplace(nodes[i]->core());
            for (const auto& [label, address] : programs[i].labels)
                times[i]->times[address];
        }
        std::array<std::uint8_t, 64> message;
        std::iota(message.begin(), message.end(), std::uint8_t{1});
        nodes[0]->core().copy_to_memory(message_at, message);
        world.connect(*nodes[0], 1, *nodes[1], 1);
        for (transputer::Node* each : nodes)
            world.boot(world.host(*each), from_start(0x200), from_start(0x800));
    }
    std::optional<Time> began(std::size_t node, const char* label) { return times[node]->times[programs[node][label]]; }
    std::string received(std::uint32_t bytes) const {
        std::string text;
        for (std::uint32_t i = 0; i < bytes; ++i)
            text += fmt::format("{} ", nodes[1]->core().memory().byte(message_at + i));
        return text;
    }

    NodeWorld world;
    std::array<transputer::Node*, 2> nodes;
    std::array<Assembly, 2> programs;
    std::array<std::optional<InstructionTimes>, 2> times;
};

std::string first_numbers(std::uint32_t count) {
    std::string text;
    for (std::uint32_t i = 1; i <= count; ++i)
        text += fmt::format("{} ", i);
    return text;
}

/// Returns the parts of `total` bytes that the bits of a number divide.
std::vector<std::uint32_t> parts_of(std::uint32_t total, std::uint32_t cuts) {
    std::vector<std::uint32_t> parts{1};
    for (std::uint32_t i = 1; i < total; ++i)
        if (cuts >> (i - 1) & 1)
            parts.push_back(1);
        else
            ++parts.back();
    return parts;
}

std::string in_parts(const char* instruction, std::uint32_t channel, const std::vector<std::uint32_t>& parts) {
    std::string text;
    std::uint32_t from = 0;
    for (const std::uint32_t each : parts) {
        text += communication(instruction, channel, from, each);
        from += each;
    }
    return text + "done: " + note_word(0x8f0, 1) + "stopp\n";
}

} // namespace

TEST_CASE("bytes arrive whatever the counts of the instructions at both ends are") {
    for (std::uint32_t total = 1; total <= (test::sanitized ? 4 : 6); ++total)
        for (std::uint32_t sent = 0; sent < 1u << (total - 1); ++sent)
            for (std::uint32_t received = 0; received < 1u << (total - 1); ++received) {
                CAPTURE(total);
                CAPTURE(sent);
                CAPTURE(received);
                const bool sender_first = (sent + received) % 2 == 0;
                LinkedPair two(
                    (sender_first ? "" : delay_loop(60, "a")) + in_parts("out", there_out, parts_of(total, sent)),
                    (sender_first ? delay_loop(60, "a") : "") + in_parts("in", here_in, parts_of(total, received)));
                two.world.run();
                REQUIRE_EQ(two.received(total), first_numbers(total));
                REQUIRE_EQ(word_at(*two.nodes[0], 0x8f0), 1);
                REQUIRE_EQ(word_at(*two.nodes[1], 0x8f0), 1);
            }
}

TEST_CASE("the channel word of a link decides the direction, not the instruction") {
    LinkedPair two(communication("in", there_out, 0, 5) + "stopp", communication("out", here_in, 0, 5) + "stopp");
    two.world.run();
    CHECK_EQ(two.received(5), first_numbers(5));
    CHECK_EQ(two.nodes[0]->core().memory().byte(message_at), 1);
}

TEST_CASE("the process whose descriptor stands in the channel word goes on") {
    // The first process outputs, and another descriptor is put into the channel word meanwhile.
    const std::string other = fmt::format("ldc other\nldc #{:X}\nstnl -1\nldc starter\nldc #{:X}\nstnl -1\n"
                                          "ldc #{:X}\nrunp\n",
                                          from_start(0x880), from_start(0x840), from_start(0x841));
    LinkedPair two(
        other + communication("out", there_out, 0, 5) + note_word(0x8f0, 1) + "stopp\nstarter: " +
            fmt::format("ldc #{:X}\nldc #{:X}\nstnl 0\nstopp\nother: ", from_start(0x881), from_start(there_out)) +
            note_word(0x8f4, 1) + "stopp",
        delay_loop(100, "a") + communication("in", here_in, 0, 5) + "stopp");
    two.world.run();
    CHECK_EQ(word_at(*two.nodes[0], 0x8f0), 0);
    CHECK_EQ(word_at(*two.nodes[0], 0x8f4), 1);
    CHECK_EQ(two.received(5), first_numbers(5));
}

TEST_CASE("an input of a byte that has come gives way to a process that is ready") {
    const std::string other =
        fmt::format("ldc other\nldc #{:X}\nstnl -1\nldc #{:X}\nrunp\n", from_start(0x840), from_start(0x841));
    LinkedPair two(communication("out", there_out, 0, 1) + "stopp", delay_loop(100, "a") + other +
                                                                        communication("in", here_in, 0, 1) +
                                                                        "goes_on: ldc 0\nstopp\nother: ldc 0\nstopp");
    two.world.run();
    REQUIRE(two.began(1, "goes_on").has_value());
    CHECK_LT(*two.began(1, "other"), *two.began(1, "goes_on"));
}

TEST_CASE("an alternation is ready with the first byte, which stays in the engine without an acknowledge") {
    for (const bool waits : {false, true})
        for (const std::uint32_t bytes : {1u, 3u}) {
            CAPTURE(waits);
            CAPTURE(bytes);
            const std::string alternation =
                fmt::format("alt\nldc #{:X}\nldc 1\nenbc\naltwt\nldc #{:X}\nldc 1\nldc 0\ndisc\naltend\n",
                            from_start(here_in), from_start(here_in));
            LinkedPair two(
                (waits ? delay_loop(100, "a") : "") + communication("out", there_out, 0, bytes) + "sent: ldc 0\nstopp",
                (waits ? "" : delay_loop(100, "a")) + alternation + "selected: ldc 0\n" + delay_loop(50, "b") +
                    "asks: ldc 0\n" + communication("in", here_in, 0, bytes) + "stopp");
            two.world.run();
            REQUIRE(two.began(0, "sent").has_value());
            CHECK_EQ(two.received(bytes), first_numbers(bytes));
            CHECK_GT(*two.began(0, "sent"), *two.began(1, "asks"));
        }
}

TEST_CASE("an alternation that takes another guard leaves the byte in the engine") {
    // The guard that is always ready is asked first.
    const std::string alternation = fmt::format(
        "alt\nldc 1\nenbs\nldc #{0:X}\nldc 1\nenbc\naltwt\nldc 1\nldc skip - base\ndiss\nldc #{0:X}\nldc 1\n"
        "ldc link - base\ndisc\naltend\nbase:\nskip: {1}\nj on\nlink: {2}on:\n",
        from_start(here_in), note_word(0x8f0, 1), note_word(0x8f4, 1));
    LinkedPair two(communication("out", there_out, 0, 4) + "sent: ldc 0\nstopp",
                   delay_loop(100, "a") + alternation + "asks: ldc 0\n" + communication("in", here_in, 0, 4) + "stopp");
    two.world.run();
    CHECK_EQ(word_at(*two.nodes[1], 0x8f0), 1);
    CHECK_EQ(word_at(*two.nodes[1], 0x8f4), 0);
    CHECK_EQ(two.received(4), first_numbers(4));
    CHECK_GT(*two.began(0, "sent"), *two.began(1, "asks"));
    CHECK_EQ(word_at(*two.nodes[1], here_in), transputer::not_a_process);
}

namespace {

/// The cycles from the arrival of a byte until a process of high priority, which has waited for it, goes on. Another
/// process executes `low` in a loop.
double interrupt_latency(const std::string& low, Time byte_begins) {
    NodeWorld world;
    transputer::Node& node = world.node("n", {});
    const Assembly program = assemble(
        fmt::format("ldc high\nldc #{:X}\nstnl -1\nldc #{:X}\nrunp\nldc 0\nfpldzerodb\nloop: {}\nj loop\nhigh: ",
                    from_start(0x840), from_start(0x840), low) +
            communication("in", here_in, 0, 1) + "woken: ldc 0\nldc loop - end\nldpi\nend: stopp",
        from_start(0x200));
    NodeWorld::put(node, program);
    InstructionTimes times(node.core());
    times.times[program["woken"]];
    world.boot(world.host(node), from_start(0x200), from_start(0x800));
    world.host(node, 1).will_give(byte_begins, {1});
    world.run(byte_begins + 100us);
    const Time latency = *times.times.at(program["woken"]) - (byte_begins + hardware::LinkTiming{}.data());
    return static_cast<double>(latency.count()) / 50'000;
}

struct Latencies {
    double least = 1e9, most = 0;
};
Latencies latencies(const std::string& low) {
    Latencies all;
    for (int i = 0; i < 240; ++i) {
        const double each = interrupt_latency(low, 200us + i * 25ns);
        all.least = std::min(all.least, each);
        all.most = std::max(all.most, each);
    }
    return all;
}

} // namespace

TEST_CASE("a process of high priority that waits for a link interrupts after 19 cycles, 58 at most, 78 with reals") {
    // The interrupt waits for the end of the instruction under way.
    const Latencies simple = latencies("ldc 0\nldc 0\nldc 0\nldc 0\nldc 0\nldc 0\nldc 0\nldc 0");
    CHECK_GE(simple.least, 19);
    CHECK_LT(simple.least, 19.5);        // the byte arrives within a half cycle
    CHECK_LT(simple.most, 19 + 4 + 0.5); // j with a prefix
    const Latencies division = latencies("ldc 7\nldc 3\ndiv");
    CHECK_LT(division.least, 19.5);
    CHECK_GT(division.most, 57.5);
    CHECK_LT(division.most, 58 + 1 + 0.5); // a prefix
    // A move is interrupted in the middle.
    const Latencies move =
        latencies(fmt::format("ldc #{:X}\nldc #{:X}\nldc 400\nmove", from_start(0xa00), from_start(0xc00)));
    CHECK_LT(move.most, 19 + 8 + 0.5); // the load of an address takes 8 cycles
    const Latencies reals = latencies("fpldzerodb\nfpldzerodb\nfpdiv\nldlp 20\nfpstnldb");
    CHECK_GT(reals.most, 40);
    CHECK_LE(reals.most, 78);
}

TEST_CASE("resetch forgets the output of a process, which can then be made ready, and the link works after a reset") {
    // The partner is busy and has not asked for the bytes; it resets its end, too.
    const std::string rescue =
        fmt::format("ldc rescue\nldc #{0:X}\nstnl -1\nldc #{1:X}\nrunp\n", from_start(0x840), from_start(0x841)) +
        communication("out", there_out, 10, 4) + "goes_on: ldc 0\n" + delay_loop(400, "b") +
        communication("out", there_out, 0, 4) + "sent: ldc 0\nstopp\nrescue: " + delay_loop(100, "a") +
        fmt::format("ldc #{:X}\nresetch\nrunp\nstopp\n", from_start(there_out));
    for (const bool asked : {false, true}) {
        CAPTURE(asked);
        // The receiver has taken 2 of the 4 bytes when it is reset, or none.
        const std::string other =
            fmt::format("ldc second\nldc #{:X}\nstnl -1\nldc #{:X}\nrunp\n", from_start(0x840), from_start(0x841));
        LinkedPair two(rescue, other + (asked ? communication("in", here_in, 20, 2) : "") + "stopp\nsecond: " +
                                   delay_loop(200, "c") + fmt::format("ldc #{:X}\nresetch\n", from_start(here_in)) +
                                   communication("in", here_in, 0, 4) + "received: ldc 0\nstopp");
        two.world.run();
        REQUIRE(two.began(0, "goes_on").has_value());
        CHECK(two.began(0, "sent").has_value());
        CHECK(two.began(1, "received").has_value());
        CHECK_EQ(two.received(4), first_numbers(4));
        CHECK_EQ(word_at(*two.nodes[0], there_out), transputer::not_a_process);
        CHECK_EQ(word_at(*two.nodes[1], here_in), transputer::not_a_process);
    }
}

TEST_CASE("resetch forgets an input in the middle, and keeps the bytes that have come") {
    // The sender gives 2 bytes of the 4 that the receiver asks for.
    const std::string other =
        fmt::format("ldc second\nldc #{:X}\nstnl -1\nldc #{:X}\nrunp\n", from_start(0x840), from_start(0x841));
    LinkedPair two(communication("out", there_out, 0, 2) + delay_loop(300, "a") +
                       communication("out", there_out, 2, 3) + "sent: ldc 0\nstopp",
                   other + communication("in", here_in, 0, 4) + "goes_on: ldc 0\n" +
                       communication("in", here_in, 2, 3) + "received: ldc 0\nstopp\nsecond: " + delay_loop(100, "b") +
                       fmt::format("ldc #{:X}\nresetch\nrunp\nstopp", from_start(here_in)));
    two.world.run();
    CHECK(two.began(1, "goes_on").has_value());
    CHECK(two.began(1, "received").has_value());
    CHECK(two.began(0, "sent").has_value());
    CHECK_EQ(two.received(5), first_numbers(5));
}

TEST_CASE("the bytes that came before resetch are in the memory, and the others are not") {
    const std::string other =
        fmt::format("ldc second\nldc #{:X}\nstnl -1\nldc #{:X}\nrunp\n", from_start(0x840), from_start(0x841));
    LinkedPair two(communication("out", there_out, 0, 60) + "stopp",
                   other + communication("in", here_in, 0, 60) + "stopp\nsecond: " + delay_loop(20, "b") +
                       fmt::format("ldc #{:X}\nresetch\nstopp", from_start(here_in)));
    two.world.run();
    CHECK_EQ(two.received(10), first_numbers(10));
    CHECK_EQ(two.nodes[1]->core().memory().byte(message_at + 59), 0);
    CHECK_EQ(word_at(*two.nodes[0], there_out), from_start(0x801)); // the sender waits until it is reset, too
}
