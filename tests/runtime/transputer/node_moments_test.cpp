// Tests moments at which several things happen to an emulated transputer, or something happens while it has run ahead.

#include "node_world.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <optional>
#include <string>
#include <vector>

using namespace placedpar;
using namespace placedpar::test;
using transputer::assemble;
using transputer::Assembly;
using namespace std::chrono_literals;

namespace {

/// Returns instructions that make a process of low priority ready.
std::string starts(const char* label, std::uint32_t workspace, std::uint32_t priority = 1) {
    return fmt::format("ldc {}\nldc #{:X}\nstnl -1\nldc #{:X}\nrunp\n", label, from_start(workspace),
                       from_start(workspace) + priority);
}

/// Returns the input of bytes from a link.
std::string takes(std::uint32_t link, std::uint32_t bytes, std::uint32_t to = 0x900) {
    return fmt::format("ldc #{:X}\nldc #{:X}\nldc {}\nin\n", from_start(to), from_start(0x10 + 4 * link), bytes);
}

/// A node with a program and a host at link 0, which boots it.
struct TimedNode {
    explicit TimedNode(const std::string& source, bool one_by_one = false, const NodeWorld::Options& options = {})
        : node(world.node("n", options)), program(assemble(source, from_start(0x200))) {
        if (one_by_one)
            node.run_instruction_by_instruction();
        NodeWorld::put(node, program);
    }
    /// Notes when the instructions at the labels begin. REQUIRES: the run has not begun.
    void watch() {
        times.emplace(node.core());
        for (const auto& [label, address] : program.labels)
            times->times[address];
    }
    void boot() { world.boot(world.host(node), from_start(0x200), from_start(0x800)); }
    Time began(const char* label) const { return times->times.at(program[label]).value_or(Time::max()); }

    NodeWorld world;
    transputer::Node& node;
    Assembly program;
    std::optional<InstructionTimes> times;
};

/// Starts a process behind the others, and is its code.
const std::string busy_loop = starts("busy", 0x8c0) + "stopp\nbusy: ldc 7\nldc 3\ndiv\nj busy\n";

} // namespace

TEST_CASE("processes that links wake at one time become ready in the order of their channels") {
    for (const bool second_link_first : {false, true}) {
        TimedNode timed(starts("one", 0x840) + starts("two", 0x880) + "stopp\none: " + takes(2, 1) +
                        "goes_on: ldc 0\nstopp\ntwo: " + takes(1, 1) + "also: ldc 0\nstopp");
        timed.watch();
        for (const int link : second_link_first ? std::array{2, 1} : std::array{1, 2})
            timed.world.host(timed.node, link).will_give(100us, {5});
        timed.boot();
        timed.world.run();
        CHECK_LT(timed.began("also"), timed.began("goes_on"));
    }
}

TEST_CASE("a process that has used up its timeslice gives way to one that a link wakes, at its next jump") {
    TimedNode timed(starts("waits", 0x840) + busy_loop + "waits: " + takes(1, 1) + "woken: ldc 0\nstopp");
    timed.watch();
    timed.world.host(timed.node, 1).will_give(3010us, {5});
    timed.boot();
    timed.world.run(4ms);
    CHECK_GT(timed.began("woken"), 3010us);
    CHECK_LT(timed.began("woken"), 3010us + 550ns + 2500ns); // a turn of the loop
}

TEST_CASE("a stop is told at the time at which the core stops") {
    TimedNode timed("sethalterr\nldc 0\nstl 1\nldc 500\nstl 2\nbegin: ldlp 1\nldc end - begin\nlend\nend: seterr");
    Time told{};
    timed.node.when_stopped([&] { told = timed.world.simulation.processes().front().kernel().now(); });
    timed.boot();
    timed.world.run();
    CHECK_GT(told, 250us);
    CHECK_EQ(told, timed.node.core().local_time());
}

TEST_CASE("an alternation that a link wakes notes the clock of that moment, however far the core has run ahead") {
    // The clock of low priority ticks every 64 us.
    for (int i = 0; i < 32; ++i) {
        CAPTURE(i);
        std::array<std::uint32_t, 2> noted;
        for (const bool one_by_one : {false, true}) {
            TimedNode timed("ldc 0\nsttimer\n" + starts("waits", 0x840) + busy_loop +
                                fmt::format("waits: talt\nldc 1000\nldc 1\nenbt\nldc #{:X}\nldc 1\nenbc\ntaltwt\nstopp",
                                            from_start(0x14)),
                            one_by_one);
            timed.world.host(timed.node, 1).will_give(300us + i * 2us, {5});
            timed.boot();
            timed.world.run(400us);
            noted[one_by_one] = word_at(timed.node, 0x840 - 20);
        }
        CHECK_EQ(noted[0], noted[1]);
        CHECK_GE(noted[0], 3);
        CHECK_LE(noted[0], 5);
    }
}

TEST_CASE("timers and links make processes ready in the order of time, also within an instruction") {
    const std::string program = "ldc 0\nsttimer\nbegun: ldc 0\n" + starts("timer", 0x840) + starts("link", 0x880) +
                                busy_loop + "timer: ldc 3\ntin\nlate: ldc 0\nstopp\nlink: " + takes(1, 1) +
                                "woken: ldc 0\nstopp";
    TimedNode first(program);
    first.watch();
    first.world.host(first.node, 1);
    first.boot();
    first.world.run(1ms);
    const Time due = first.began("begun") + 4 * 64us;
    for (Time arrival = due - 3us; arrival <= due + 3us; arrival += 100ns) {
        TimedNode timed(program);
        timed.watch();
        timed.world.host(timed.node, 1).will_give(arrival - hardware::LinkTiming{}.data(), {5});
        timed.boot();
        timed.world.run(4ms);
        CAPTURE((arrival - due).count());
        REQUIRE_LT(std::max(timed.began("woken"), timed.began("late")), Time::max());
        CHECK_EQ(timed.began("woken") < timed.began("late"), arrival <= due);
    }
}

namespace {

/// Runs a node whose links are busy in all directions. A process of high priority notes each microsecond or so how far
/// one of low priority has counted. Returns the memory.
std::vector<std::uint8_t> memory_after_traffic(int memory_cycles, bool one_by_one,
                                               std::int64_t bits_per_second = hardware::LinkTiming::usual_speed) {
    std::string program = "ldc 0\nsttimer\n", processes;
    for (std::uint32_t link = 0; link < 4; ++link) {
        const std::string in = fmt::format("in{}", link), out = fmt::format("out{}", link);
        program += starts(in.c_str(), 0xa00 + 0x80 * link) + starts(out.c_str(), 0xa40 + 0x80 * link);
        processes += fmt::format("{}: {}{}stopp\n", in, takes(link, 300 + link, 0x3000 + 0x200 * link),
                                 takes(link, 500, 0x3000 + 0x200 * link));
        processes += fmt::format("{}: ldc #{:X}\nldc #{:X}\nldc {}\nout\nstopp\n", out, from_start(0x4000),
                                 from_start(4 * link), 700 + link);
    }
    program +=
        starts("notes", 0xc40, 0) + starts("counts", 0xc80) + "stopp\n" + processes +
        "counts: ldl 1\nadc 1\nstl 1\nldlp 6\nfpldnlsn\nfpdup\nfpdiv\nldl 1\nldlp 7\nfpstnlsn\nj counts\n"
        "notes: ldtimer\nstl 1\nldc 0\nstl 2\nagain: ldl 1\nadc 3\nstl 1\nldl 1\ntin\n"
        "ldtimer\nldl 2\nldc #80002000\nwsub\nstnl 0\nldc #80000c84\nldnl 0\nldl 2\nldc #80002400\nwsub\nstnl 0\n"
        "ldl 2\nadc 1\nldc 255\nand\nstl 2\nj again";
    TimedNode timed(program, one_by_one,
                    {.model = transputer::Model::t800, .memory = 32768, .timing = {.memory_cycles = memory_cycles}});
    for (int link = 0; link < 4; ++link) {
        ScriptedEnd& host = timed.world.host(timed.node, link, {.bits_per_second = bits_per_second});
        if (link == 0)
            timed.world.boot(host, from_start(0x200), from_start(0x800));
        host.will_give(100us, std::vector<std::uint8_t>(1000, 7));
    }
    timed.world.run(1ms);
    const auto memory = timed.node.core().memory().bytes(0x2000, 0x400 + 4 * 256);
    return {memory.begin(), memory.end()};
}

} // namespace

TEST_CASE("timers are attended to at their times while the links take accesses to the memory") {
    for (const int memory_cycles : {3, 4, 5, 6}) {
        CAPTURE(memory_cycles);
        CHECK(memory_after_traffic(memory_cycles, false) == memory_after_traffic(memory_cycles, true));
    }
}

TEST_CASE("links that are faster than the memory leave the times of timers as they are") {
    for (const std::int64_t speed : {5'000'000, 30'000'000, 40'000'000, 60'000'000, 100'000'000, 200'000'000})
        for (const int memory_cycles : {2, 3, 4, 6, 9, 20}) {
            CAPTURE(speed);
            CAPTURE(memory_cycles);
            CHECK(memory_after_traffic(memory_cycles, false, speed) ==
                  memory_after_traffic(memory_cycles, true, speed));
        }
}

TEST_CASE("instructions are counted once although a program overwrites those that follow") {
    std::array<std::uint64_t, 2> counted;
    for (const bool one_by_one : {false, true}) {
        TimedNode timed("ldc #43\nldc changes\nsb\nldc 0\nldc 0\nchanges: ldc 7\nstl 1\nstopp", one_by_one);
        timed.boot();
        timed.world.run();
        CHECK_EQ(word_at(timed.node, 0x804), 3);
        counted[one_by_one] = timed.node.core().instructions();
    }
    CHECK_EQ(counted[0], 4 + 8); // the loader, the program
    CHECK_EQ(counted[1], counted[0]);
}
