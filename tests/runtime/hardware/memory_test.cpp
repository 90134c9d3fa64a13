// Tests how link engines slow down a processor's computing, in cases computed by hand. For random cases see
// link_alternation_test.cpp.

#include "runtime/channel.hpp"
#include "runtime/hardware/instructions.hpp"
#include "runtime/hardware/link.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/parallel.hpp"
#include "runtime/random.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"
#include "tests/runtime/cycle.hpp"
#include "tests/sanitized.hpp"
#include "tests/seeds.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <deque>
#include <numeric>
#include <stdexcept>
#include <vector>

using namespace placedpar;
using namespace placedpar::hardware;
using std::chrono::milliseconds;
using test::cycle;
using test::replay;
using test::sanitized;
using test::seeds;

namespace {

struct MovedBlock {
    std::uint32_t bytes;
    WireForm wire_form() const { return WireForm(bytes); }
};
using Bytes = Channel<MovedBlock>;

constexpr std::int64_t twenty_megahertz = 20'000'000;

/// A processor with a link. Processes without a processor use the link at the same time.
struct OneLink {
    explicit OneLink(const Memory& memory, bool receives = true)
        : processor(simulation.add<Processor>("t", twenty_megahertz, Cycles{0}, memory)), link(simulation.add<Link>()) {
        processor.has_link(link);
        channel.put_on(receives ? link.from_a_to_b() : link.from_b_to_a());
    }
    /// Sends `messages` messages of this many bytes, the first at `start`.
    void carry(int messages, std::uint32_t bytes, Time start = {}) {
        simulation.process("sends", [=, this] {
            wait_until(start);
            for (int i = 0; i < messages; ++i)
                channel.out().output({bytes});
        });
        simulation.process("receives", [=, this] {
            for (int i = 0; i < messages; ++i)
                channel.in().input();
        });
    }
    /// Returns how long a process takes to compute `cycles` cycles.
    Time computing(Cycles cycles, Priority priority = Priority::low) {
        Time took{};
        simulation.process(
            "computes",
            [&, cycles] {
                Time start = now();
                compute(cycles);
                took = now() - start;
            },
            &processor, priority);
        simulation.run();
        return took;
    }

    Simulation simulation;
    Processor& processor;
    Link& link;
    Bytes channel{"channel"};
};

/// Sends three random messages in each direction of a link. Returns the bytes moved and the time occupied in each
/// direction, at 6,000 times. These times are tenths of a bit, or a picosecond before or after them.
std::vector<std::int64_t> observed(std::uint64_t seed, bool every_byte) {
    RandomStream random(seed, "two directions");
    LinkTiming timing{.bits_per_second =
                          std::array{20'000'000, 10'000'000, 5'000'000, 7'000'000, 5'333}[random.below(5)]};
    const Time tenth = duration_of(1, 10 * timing.bits_per_second);
    timing.overlapped_acknowledge = random.chance(0.75);
    timing.wire_delay = random.chance(0.3) ? random.below(200) * tenth : Time{0};
    Simulation simulation;
    auto& processor = simulation.add<Processor>("t");
    auto& link = simulation.add<Link>(timing);
    processor.has_link(link);
    const std::array bytes{1 + random.below(60), 1 + random.below(60)};
    std::deque<Bytes> channels;
    for (LinkDirection* direction : {&link.from_a_to_b(), &link.from_b_to_a()}) {
        if (every_byte)
            direction->simulate_every_byte();
        const bool is_second = !channels.empty();
        Bytes& channel = channels.emplace_back("", *direction);
        // The second direction begins later. In half of the cases it begins with the first direction's last byte.
        Time start = (random.chance(0.5) ? 112 * (bytes[0] - 1) : random.below(600)) * (is_second ? tenth : Time{0});
        simulation.process("sends", [&channel, own = bytes[is_second], start] {
            wait_for(start);
            for (int i = 0; i < 3; ++i)
                channel.out().output({own});
        });
        simulation.process("receives", [&channel, pause = random.below(600) * tenth] {
            for (int i = 0; i < 3; ++i) {
                channel.in().input();
                wait_for(pause);
            }
        });
    }
    std::vector<std::int64_t> log;
    simulation.process("observes", [&, step = tenth + Time{random.below(3)} - Time{1}] {
        for (int i = 0; i < 6'000; ++i) {
            wait_for(step);
            log.push_back(processor.memory_taken_by_links().count());
            for (const LinkDirection* direction : {&link.from_a_to_b(), &link.from_b_to_a()}) {
                log.push_back(static_cast<std::int64_t>(direction->bytes_carried()));
                log.push_back(direction->time_occupied().count());
            }
        }
    });
    simulation.run();
    return log;
}

} // namespace

TEST_CASE("a computing process waits for one access for each word that comes or goes meanwhile") {
    for (bool receives : {false, true})
        for (std::int64_t access : {1, 3, 5}) {
            CAPTURE(access);
            OneLink t({.access = Cycles{access}}, receives);
            t.carry(1, 4000);
            CHECK(t.computing(Cycles{100'000}) == (100'000 + 1000 * access) * cycle);
            CHECK(t.processor.time_busy() == (100'000 + 1000 * access) * cycle);
            CHECK(t.processor.memory_taken_by_links() == 1000 * access * cycle);
        }
}

TEST_CASE("remaining bytes at the end of a message are one more word, and a T2 has twice as many words") {
    for (auto [bytes_in_a_word, words] : {std::pair{4, 2}, {2, 3}}) {
        OneLink t({.access = Cycles{3}, .bytes_in_a_word = bytes_in_a_word});
        t.carry(10, 5);
        CHECK(t.computing(Cycles{10'000}) == (10'000 + 10 * words * 3) * cycle);
    }
}

TEST_CASE("a message before or after the computation does not slow it down") {
    OneLink after({.access = Cycles{3}});
    after.carry(1, 4000, 100'000 * cycle);
    CHECK(after.computing(Cycles{100'000}) == 100'000 * cycle);
    CHECK(after.processor.memory_taken_by_links() == 3000 * cycle);

    OneLink before({.access = Cycles{3}});
    before.carry(1, 4000);
    before.simulation.process("late", [&] { wait_until(milliseconds{5}); });
    Time took{};
    before.simulation.process(
        "computes",
        [&] {
            wait_until(milliseconds{4}); // 4000 bytes of 560 ns have passed
            Time start = now();
            compute(Cycles{1000}), took = now() - start;
        },
        &before.processor, Priority::high);
    before.simulation.run();
    CHECK(took == 1000 * cycle);
}

TEST_CASE("a computation waits for the words that arrive until its end, including those during the delay") {
    OneLink t({.access = Cycles{3}});
    t.carry(1, 400'000);
    // There is a byte every 560 ns and a word every 2.24 us. Each access takes .15 us, so 1 ms becomes 1 / (1 - .15 /
    // 2.24) ms.
    Time took = t.computing(Cycles{20'000});
    auto words = (took - 20'000 * cycle) / (3 * cycle);
    CHECK(took == 20'000 * cycle + words * 3 * cycle);
    CHECK(words == 479); // 1 ms / (2.24 - .15) us = 478.5, plus the current word
}

TEST_CASE(
    "the time of link accesses does not count in a process's timeslice, and it keeps its place before its rivals") {
    Simulation simulation;
    Processor& t800 = simulation.add<Processor>("t", twenty_megahertz, Cycles{0}, Memory{.access = Cycles{3}});
    Link& link = simulation.add<Link>();
    t800.has_link(link);
    Bytes channel("channel");
    channel.put_on(link.from_a_to_b());
    simulation.process("sends", [&] { channel.out().output({100'000}); });
    simulation.process("receives", [&] { channel.in().input(); });
    std::vector<Time> ended(2);
    for (int i : {0, 1})
        simulation.process(
            fmt::format("computes {}", i),
            [&, i] {
                compute(Cycles{10'000});
                ended[static_cast<std::size_t>(i)] = now();
            },
            &t800);
    simulation.run();
    // Each process computes for half a timeslice. The accesses of the links extend this time.
    CHECK(ended[0] > 10'000 * cycle);
    CHECK(ended[0] < 10'800 * cycle);
    CHECK(ended[1] > ended[0] + 10'000 * cycle);
    CHECK(t800.time_busy() == ended[1]);
}

TEST_CASE("an interrupt does not lose the time of link accesses") {
    OneLink t({.access = Cycles{3}});
    t.carry(1, 4000);
    t.simulation.process(
        "high",
        [] {
            for (int i = 1; i <= 20; ++i)
                wait_until(i * 5000 * cycle), compute(Cycles{500});
        },
        &t.processor, Priority::high);
    Time took = t.computing(Cycles{200'000});
    CHECK(t.processor.memory_taken_by_links() == 3000 * cycle);
    // There are 20 interrupts, and all accesses fall into a computation of one of the processes.
    CHECK(took == (200'000 + 20 * (500 + 19) + 3000) * cycle);
}

TEST_CASE("in a chain of seven that stores, forwards and computes, each inner processor waits for both its links") {
    constexpr int nodes = 7, messages = 20;
    constexpr std::uint32_t bytes = 4000;
    constexpr std::int64_t work = 200'000; // 10 ms, longer than a message takes, so that computing is the bottleneck
    Simulation simulation;
    std::deque<Bytes> channels;
    std::vector<Processor*> chain;
    for (int i = 0; i < nodes; ++i)
        chain.push_back(&simulation.add<Processor>(fmt::format("t{}", i), twenty_megahertz, Cycles{0},
                                                   Memory{.access = Cycles{3}}));
    for (int i = 0; i + 1 < nodes; ++i) {
        Link& link = simulation.add<Link>();
        chain[static_cast<std::size_t>(i)]->has_link(link), chain[static_cast<std::size_t>(i) + 1]->has_link(link);
        channels.emplace_back(fmt::format("c{}", i)).put_on(link.from_a_to_b());
    }
    std::vector<Time> busy;
    for (int i = 0; i < nodes; ++i) {
        auto at = static_cast<std::size_t>(i);
        simulation.process(
            fmt::format("stores, forwards and computes {}", i),
            [&, at] {
                Bytes *from = at > 0 ? &channels[at - 1] : nullptr,
                      *to = at < channels.size() ? &channels[at] : nullptr;
                for (int m = 0; m <= messages; ++m) // one message is stored while the previous one is forwarded
                    par(
                        [&] {
                            if (from && m < messages)
                                from->in().input();
                        },
                        [&] {
                            if (to && m > 0)
                                to->out().output({bytes});
                        },
                        [&] { compute(Cycles{work}); });
            },
            chain[at]);
    }
    REQUIRE(simulation.run().ending == Ending::completed);
    constexpr std::int64_t words = messages * bytes / 4 * 3;
    for (std::size_t i = 0; i < chain.size(); ++i) {
        CAPTURE(i);
        bool inner = i > 0 && i + 1 < chain.size();
        CHECK(chain[i]->memory_taken_by_links() == (inner ? 2 : 1) * words * cycle);
        Time own = (messages + 1) * work * cycle;
        // Before the first message arrives, no transfer slows down the computing.
        CHECK(chain[i]->time_busy() >= own + (inner ? 2 : 1) * words * cycle * (messages - 2) / messages);
        CHECK(chain[i]->time_busy() < own + (inner ? 2 : 1) * words * cycle + (messages + 1) * 200 * cycle);
    }
}

TEST_CASE("a load divided along a chain of seven under the C toolset takes the time computed by hand") {
    // With these numbers of words and 200 cycles of load for each word, all processors would end together if links took
    // no cycles.
    constexpr std::array<std::uint32_t, 7> words{26'302, 16'513, 10'423, 6'668, 4'406, 3'131, 2'557};
    Simulation simulation;
    std::vector<Processor*> chain;
    for (std::size_t i = 0; i < words.size(); ++i)
        chain.push_back(&simulation.add<Processor>(fmt::format("t{}", i), twenty_megahertz,
                                                   instructions::toolset_channel_call, Memory{.access = Cycles{3}}));
    std::deque<Bytes> channels;
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        Link& link = simulation.add<Link>();
        chain[i]->has_link(link), chain[i + 1]->has_link(link);
        channels.emplace_back(fmt::format("c{}", i)).put_on(link.from_a_to_b());
    }
    auto behind = [&](std::size_t i) { return std::accumulate(words.begin() + i + 1, words.end(), 0u); };
    std::array<Time, 7> began{}, ended{};
    for (std::size_t i = 0; i < words.size(); ++i)
        simulation.process(
            fmt::format("p{}", i),
            [&, i] {
                if (i > 0)
                    channels[i - 1].in().input();
                began[i] = now();
                pri_par(
                    [&] {
                        if (i < channels.size())
                            channels[i].out().output({4 * behind(i)});
                    },
                    [&] { compute(200 * Cycles{words[i]}), ended[i] = now(); });
            },
            chain[i], Priority::high);
    simulation.run();
    Time by_hand{};
    for (std::size_t i = 0; i < words.size(); ++i) {
        CAPTURE(i);
        constexpr Time slack = std::chrono::microseconds{17}; // for startp, interrupts and rescheduling, out of 270 ms
        CHECK(began[i] >= by_hand);
        CHECK(began[i] < by_hand + slack);
        // Computing lasts longer than forwarding, which takes three cycles of the computation for each word.
        Time own = (200 * std::int64_t{words[i]} + 3 * std::int64_t{behind(i)}) * cycle;
        CHECK(ended[i] >= by_hand + own);
        CHECK(ended[i] < by_hand + own + slack);
        by_hand += std::chrono::microseconds{11} + behind(i) * std::chrono::nanoseconds{2240};
    }
}

TEST_CASE("a copy on a soft channel reads and writes its words, at 13.3 Mbyte/s outside of the chip (databook)") {
    Simulation simulation;
    Processor& t800 = simulation.add<Processor>("t", twenty_megahertz, Cycles{0}, Memory{.access = Cycles{3}});
    Bytes channel("soft");
    Time ended{};
    simulation.process(
        "outputs", [&] { channel.out().output({4'000'000}); }, &t800);
    simulation.process(
        "inputs", [&] { channel.in().input(), ended = now(); }, &t800);
    simulation.run();
    CHECK(4e6 / static_cast<double>(ended.count()) * 1e12 == doctest::Approx(13.3e6).epsilon(.005));
}

TEST_CASE("words of code and data outside of the chip extend a computation by the longer access") {
    for (std::int64_t access : {1, 3, 5}) {
        Simulation simulation;
        Processor& t800 = simulation.add<Processor>("t", twenty_megahertz, Cycles{0}, Memory{.access = Cycles{access}});
        Time took{};
        simulation.process(
            "computes", [&] { compute(Cycles{1000}, {.words_outside = 400}), took = now(); }, &t800);
        simulation.run();
        CHECK(took == (1000 + 400 * (access - 1)) * cycle);
    }
    Simulation simulation;
    auto& t800 = simulation.add<Processor>("t", twenty_megahertz, Cycles{0}, Memory{.access = Cycles{3}});
    simulation.process(
        "computes", [] { compute(Cycles{1}, {.words_outside = -1}); }, &t800);
    CHECK_THROWS_WITH(simulation.run(), "process computes computes with a negative number of words outside the chip");
}

TEST_CASE("memory that takes no time, or has words of another size, is refused") {
    Simulation simulation;
    CHECK_THROWS_AS(simulation.add<Processor>("t", twenty_megahertz, Cycles{0}, Memory{.access = Cycles{0}}),
                    std::logic_error);
    CHECK_THROWS_AS(simulation.add<Processor>("t", twenty_megahertz, Cycles{0}, Memory{.bytes_in_a_word = 8}),
                    std::logic_error);
}

TEST_CASE("the bytes moved by links are known at every moment as if each byte were an event") {
    for (std::uint64_t seed : seeds(400)) {
        INFO(replay(seed));
        CHECK(observed(seed, false) == observed(seed, true));
    }
}

TEST_CASE("a message that begins with the last byte of the other direction has not moved any words") {
    constexpr Time last_byte_begins = 99 * std::chrono::nanoseconds{560};
    OneLink t{Memory{}};
    Bytes back("back", t.link.from_b_to_a());
    Time taken{};
    t.carry(1, 100);
    t.simulation.process("answers", [&] { wait_until(last_byte_begins), back.out().output({1000}); });
    t.simulation.process("asks", [&] { back.in().input(); });
    t.simulation.process("observes", [&] {
        wait_until(last_byte_begins);
        taken = t.processor.memory_taken_by_links();
    });
    t.simulation.run();
    CHECK(taken == 25 * cycle); // 99 bytes began before, and none of the 1000 bytes
}
