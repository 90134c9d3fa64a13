// Compares the processes that a search finds to wait with programs of known answers, and with what a watcher saw.

#include "runtime/transputer/waiting.hpp"

#include "node_world.hpp"
#include "random_network.hpp"
#include "runtime/random.hpp"
#include "runtime/transputer/core_text.hpp"
#include "tests/seeds.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <vector>

using namespace placedpar;
using namespace placedpar::test;
using transputer::WaitingProcess;
using transputer::Word;

namespace {

/// Returns a line for each process that waits: "W+3 low: inputs #80000004".
std::vector<std::string> found(transputer::Node& node) {
    constexpr std::string_view waits[] = {"inputs", "outputs", "alternates", "delayed"};
    std::vector<std::string> lines;
    for (const WaitingProcess& each : transputer::waiting_processes(node.core())) {
        std::string line =
            fmt::format("{} {}", node.name_of_process(each.workspace), waits[static_cast<std::size_t>(each.wait)]);
        for (const Word channel : each.channels)
            line += " " + node.name_of_channel(channel);
        lines.push_back(line + (each.time ? " timer" : ""));
    }
    std::ranges::sort(lines);
    return lines;
}

/// Keeps what each process did last.
struct LastTurns final : TraceSink {
    void turns(const Process&, Activity, Time) override {}
    void communicated(const AnyChannel&, Time) override {}
    void takes(const PlaceTaken&, Time) override {}
    void leaves(const PlaceLeft&, Time) override {}
    void over(Time) override {}
    void program_turns(const ProgramTurn& turn, Time now) override {
        in_order = in_order && now >= last;
        last = now;
        ++count;
        std::string& line = lines[turn.place][turn.process];
        line.clear();
        if (!is_waiting(turn.activity) || turn.activity == Activity::stopped)
            return;
        line = fmt::format("{} {}", turn.process,
                           turn.activity == Activity::inputting     ? "inputs"
                           : turn.activity == Activity::outputting  ? "outputs"
                           : turn.activity == Activity::alternating ? "alternates"
                                                                    : "delayed");
        for (const AwaitedByProgram& each : turn.awaited)
            line += " " + each.channel;
        line += turn.awaits_timer ? " timer" : "";
    }
    std::vector<std::string> waiting(const std::string& node) const {
        std::vector<std::string> result;
        if (const auto found = lines.find(node); found != lines.end())
            for (const auto& [process, line] : found->second)
                if (!line.empty())
                    result.push_back(line);
        std::ranges::sort(result);
        return result;
    }

    std::map<std::string, std::map<std::string, std::string>> lines; ///< by node and process
    Time last{};
    bool in_order = true;
    std::size_t count = 0;
};

bool is_analysed(const RandomNetwork& network, const transputer::Node& node) {
    return network.nodes[std::stoul(node.name().substr(1))].analyse_at.has_value(); // node i is "ni"
}

/// Runs a program on a node until nothing happens, with the workspace W at #80000800.
struct RunToItsEnd {
    explicit RunToItsEnd(std::string_view source, Time limit = Time::max()) {
        world.run_at_boot(node, source);
        world.simulation.trace_to(seen);
        world.run(limit);
    }
    NodeWorld world;
    LastTurns seen;
    transputer::Node& node = world.node("t", {});
};

} // namespace

TEST_CASE("two processes that each output before they input are found, with the ends that they come to") {
    const RunToItsEnd run(R"(
        mint; stl 1; mint; stl 2
        ldc other - after; ldlp -20; startp
after:  ldlp 3; ldlp 1; ldc 4; out
        ldlp 3; ldlp 2; ldc 4; in
        stopp
other:  ldlp 0; ldlp 22; ldc 4; out
        ldlp 0; ldlp 21; ldc 4; in
        stopp
    )");
    const std::vector<WaitingProcess> waiting = transputer::waiting_processes(run.node.core());
    CHECK_EQ(found(run.node),
             std::vector<std::string>{"t.#800007B0 outputs t.#80000808", "t.#80000800 outputs t.#80000804"});
    REQUIRE_EQ(waiting.size(), 2);
    CHECK_EQ(waiting[1].priority, 1);
    CHECK_EQ(transputer::instruction_before(run.node.core(), waiting[1].instruction).instruction.operation,
             transputer::Operation::out);
    using Ends = std::vector<transputer::ChannelEnd>;
    CHECK_EQ(transputer::ends_ahead(run.node.core(), waiting[0]), Ends{{from_start(0x804), false}});
    CHECK_EQ(transputer::ends_ahead(run.node.core(), waiting[1]), Ends{{from_start(0x808), false}});
    CHECK_EQ(run.seen.waiting("t"), found(run.node));
}

TEST_CASE("waits for links, the event pin, a timer and an ALT are told apart, at both priorities") {
    const RunToItsEnd run(R"(
        ldc 0; sttimer; mint; stl 1; mint; stl 2
        ldc link - a; ldlp -20; startp
a:      ldc event - b; ldlp -40; startp
b:      ldc word - c; ldlp -60; startp
c:      ldpi urgent; ldlp -80; stnl -1; ldlp -80; runp     -- a descriptor of high priority
        ldc pause - d; ldlp -100; startp
d:      talt; ldlp 1; ldc 1; enbc; ldlp 2; ldc 1; enbc; mint; ldnlp 7; ldc 1; enbc; ldc 1000; ldc 1; enbt
        taltwt; stopp
link:   ldlp 0; mint; ldnlp 5; ldc 4; in; stopp            -- input of link 1
event:  ldlp 0; mint; ldnlp 8; ldc 0; in; stopp
word:   mint; stl 2; ldlp 2; ldc 77; outword; stopp
urgent: mint; stl 2; ldlp 0; ldlp 2; ldc 4; in; stopp
pause:  ldc 900; tin; stopp
    )",
                          std::chrono::milliseconds{1});
    CHECK_EQ(found(run.node),
             std::vector<std::string>{"t.#80000670 delayed timer", "t.#800006C0 inputs t.#800006C8",
                                      "t.#80000710 outputs t.#80000718", "t.#80000760 inputs t.event",
                                      "t.#800007B0 inputs t.link[1]",
                                      "t.#80000800 alternates t.link[3] t.#80000804 t.#80000808 timer"});
    std::vector<int> priorities;
    for (const WaitingProcess& each : transputer::waiting_processes(run.node.core()))
        priorities.push_back(each.priority);
    CHECK_EQ(priorities, std::vector<int>{1, 0, 1, 1, 1, 1});
    const std::string analysis = transputer::print_analysis(run.node.core(), {});
    CHECK_NE(analysis.find("no process runs"), std::string::npos);
    CHECK_NE(analysis.find("Wptr #800006C0, high priority, Iptr #800002"), std::string::npos);
    CHECK_NE(analysis.find("inputs, its descriptor is at #800006C8\n"), std::string::npos);
    CHECK_NE(analysis.find("inputs, its descriptor is at event\n"), std::string::npos);
    CHECK_NE(analysis.find("waits for its timer, until its clock is after 900\n"), std::string::npos);
    CHECK_NE(
        analysis.find("is in an ALT, its descriptor is at link 3 input and #80000804 and #80000808, until its clock "
                      "is after 1000\n"),
        std::string::npos);
}

TEST_CASE("pointers to workspaces, and what earlier waits have left, are not taken for waits") {
    const RunToItsEnd run(R"(
        mint; stl 1; mint; stl 2
        ldc other - after; ldlp -20; startp
after:  ldlp 3; ldlp 1; ldc 4; in
        ldlp 0; stl 5; ldlp 0; adc 1; stl 6; ldlp -20; stl 7   -- a pointer and two descriptors, after a wait at W
        ajw -8; ldlp 0; ldlp 10; ldc 4; out; stopp
other:  ldlp 0; ldlp 21; ldc 4; out; stopp
    )");
    CHECK_EQ(found(run.node), std::vector<std::string>{"t.#800007E0 outputs t.#80000808"});
    CHECK_EQ(run.seen.waiting("t"), found(run.node));
}

TEST_CASE("data that imitates a waiting process is not taken for one") {
    const RunToItsEnd run(R"(
        ldc imitation - here; ldpi
here:   ldlp -20; stnl -1                                -- a saved Iptr in the data
        ldlp -20; ldlp -20; stnl -3                      -- the pointer that outword leaves
        ldlp -20; adc 1; stl 2                           -- a word like a channel's
        mint; stl 1; ldlp 1; ldc 77; outword; stopp
        ldlp 22; ldc 77; outword
imitation: stopp
    )");
    const Word imitated = from_start(0x7B0), at = run.node.core().memory().word(0x7B0 - 4);
    CHECK_EQ(transputer::instruction_before(run.node.core(), at).instruction.operation, transputer::Operation::outword);
    CHECK_EQ(run.node.core().memory().word(0x7B0 - 12), imitated);
    CHECK_EQ(found(run.node), std::vector<std::string>{"t.#80000800 outputs t.#80000804"});
    CHECK_EQ(run.seen.waiting("t"), found(run.node));
}

TEST_CASE("old descriptors in the channel words of links, as analyse leaves them, are not taken for waits") {
    const RunToItsEnd run(R"(
        ldc waits - after; ldlp -20; startp
after:  ldc begins; ldlp -40; stnl -1                        -- a process that has not begun
        ldlp -40; adc 1; mint; stnl 4
        ldlp -20; adc 1; mint; stnl 1                        -- a process that waits for another link
        ldlp -60; adc 1; mint; stnl 5                        -- a process that waits for a timer
        ldc 0; sttimer; ldc delays - end; ldlp -60; startp
end:    stopp
begins: stopp
waits:  ldlp 0; mint; ldnlp 6; ldc 4; in; stopp              -- input of link 2
delays: ldc 900; tin; stopp
    )",
                          std::chrono::milliseconds{1});
    CHECK_EQ(found(run.node), std::vector<std::string>{"t.#80000710 delayed timer", "t.#800007B0 inputs t.link[2]"});
    CHECK_EQ(run.seen.waiting("t"), found(run.node));
}

TEST_CASE("the search finds in random networks what a watcher has seen, and watching changes nothing") {
    std::size_t turns = 0, waits = 0;
    for (const std::uint64_t seed : seeds(200)) {
        INFO(replay(seed));
        const RandomNetwork network = random_network(seed);
        RandomStream random(seed, "limit");
        for (const Time until : {Time{std::chrono::seconds{1}}, Time{random.below(800'000'000)}}) {
            CAPTURE(until.count());
            LastTurns seen;
            const std::vector<NodeOutcome> watched = run_network(
                network, {.trace = &seen,
                          .at_end =
                              [&](transputer::Node& node) {
                                  if (is_analysed(network, node)) // what comes after that may overwrite all
                                      return;
                                  waits += found(node).size();
                                  CHECK_EQ(fmt::format("{}", fmt::join(found(node), "\n")),
                                           fmt::format("{}", fmt::join(seen.waiting(node.name()), "\n")));
                                  for (const WaitingProcess& each : transputer::waiting_processes(node.core()))
                                      transputer::ends_ahead(node.core(), each);
                              },
                          .until = until});
            CHECK(seen.in_order);
            CHECK_EQ(difference_of(run_network(network, {.until = until}), watched), "");
            turns += seen.count;
        }
    }
    if (all_seeds()) {
        CHECK_GT(turns, 10'000);
        CHECK_GT(waits, 500);
    }
}
