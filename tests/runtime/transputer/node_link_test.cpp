// Tests that instructions of emulated transputers use a link in the same time as C++ processes on processors, to the
// picosecond.

#include "node_world.hpp"

#include "runtime/channel.hpp"
#include "runtime/executive.hpp"
#include "runtime/hardware/crossbar.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/random.hpp"
#include "tests/seeds.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>

#include <array>
#include <deque>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <vector>

using namespace placedpar;
using namespace placedpar::test;
using hardware::LinkFault;
using hardware::LinkTiming;
using transputer::assemble;
using transputer::Assembly;

namespace {

/// A communication of a process by the one link, and the cycles that the process computes before.
struct LinkUse {
    std::uint32_t cycles; ///< at least `least_cycles`
    std::uint32_t bytes;
};
constexpr std::uint32_t least_cycles = 120;

/// The processes at both ends of a link. A direction has the uses of its sender and of its receiver.
struct LinkCase {
    struct Direction {
        std::vector<LinkUse> sent, received;
    };
    LinkTiming timing;
    std::array<Direction, 2> directions; ///< from node 0, from node 1
    int memory_cycles = 3;
    std::vector<LinkFault> faults = {}; ///< times count from the beginning of the processes
};

/// The times at which the processes went on after each use: senders and receivers of both directions. A process that
/// was stuck has fewer.
using GoingOn = std::array<std::array<std::vector<Time>, 2>, 2>;

struct CountedBytes {
    std::uint32_t bytes;
    WireForm wire_form() const { return WireForm(bytes); }
};

std::vector<LinkFault> shifted(std::vector<LinkFault> faults, Time by) {
    for (LinkFault& fault : faults) {
        fault.from = later(fault.from, by);
        fault.until = later(fault.until, by);
    }
    return faults;
}

GoingOn on_processors(const LinkCase& all) {
    Simulation simulation;
    GoingOn times;
    std::array<hardware::Processor*, 2> processors;
    const hardware::Memory memory{.access = Cycles{all.memory_cycles}};
    for (auto& each : processors)
        each = &simulation.add<hardware::Processor>("t", 20'000'000, Cycles{0}, memory);
    auto& link = simulation.add<hardware::Link>(all.timing);
    for (const LinkFault& each : all.faults)
        link.suffer(each);
    for (auto* each : processors)
        each->has_link(link);
    std::deque<Channel<CountedBytes>> channels;
    channels.emplace_back("there", link.from_a_to_b());
    channels.emplace_back("back", link.from_b_to_a());
    const auto use = [&](std::size_t direction, bool receives) {
        const LinkCase::Direction& uses = all.directions[direction];
        const std::size_t node = receives ? 1 - direction : direction;
        simulation.process(
            "uses the link",
            [&, receives, direction] {
                for (const LinkUse& each : receives ? uses.received : uses.sent) {
                    compute(Cycles{each.cycles});
                    if (receives)
                        channels[direction].in().input();
                    else
                        channels[direction].out().output({each.bytes});
                    times[direction][receives].push_back(Kernel::here().now());
                }
                compute(Cycles{13}); // ldc, stopp
            },
            processors[node]);
    };
    // A node's sender comes first in its queue.
    for (const std::size_t node : {0u, 1u}) {
        use(node, false);
        use(1 - node, true);
    }
    simulation.run();
    return times;
}

constexpr std::uint32_t send_buffer = 0x700, receive_buffer = 0x800, first_workspace = 0x600, second_workspace = 0x680;

/// Returns the instructions of one process. It begins with `ldc 0`, and so do the instructions after each use.
std::string process_of(const std::vector<LinkUse>& uses, bool receives, const std::string& name) {
    std::string text;
    int number = 0;
    const std::uint32_t buffer = from_start(receives ? receive_buffer : send_buffer);
    for (const LinkUse& each : uses) {
        const std::string operands =
            fmt::format("ldc #{:X}\nldc #{:X}\nldc {}\n", buffer, from_start(receives ? 0x14 : 0x04), each.bytes);
        auto left = static_cast<std::uint32_t>(each.cycles - assemble(operands).bytes.size());
        text += fmt::format("{}{}: ldc 0\n", name, number++);
        --left;
        // A move of 4n bytes takes 2n + 8 cycles, its operands and its prefix the rest.
        while (left > 100) {
            const std::string move = fmt::format("ldc #{:X}\nldc #{:X}\n", from_start(0x200), from_start(0x300));
            const std::uint32_t words = std::min(left / 2, 200u) - 20;
            const std::string whole = fmt::format("{}ldc {}\nmove\n", move, 4 * words);
            left -= static_cast<std::uint32_t>(assemble(whole).bytes.size()) - 1 + 2 * words + 8;
            text += whole;
        }
        for (; left > 0; --left)
            text += "ldc 0\n";
        text += operands + (receives ? "in\n" : "out\n");
    }
    return text + fmt::format("{}{}: ldc 0\nstopp\n", name, number);
}

/// Returns the times since the first instruction of the processes of both nodes. `began` becomes this time.
GoingOn on_nodes(const LinkCase& all, Time& began) {
    NodeWorld world;
    std::array<transputer::Node*, 2> nodes;
    std::array<std::optional<InstructionTimes>, 2> watchers;
    std::array<Assembly, 2> programs;
    for (const std::size_t i : {0u, 1u}) {
        nodes[i] = &world.node("n", {.memory = 8192, .timing = {.memory_cycles = all.memory_cycles}});
        programs[i] = assemble(fmt::format("ldc second\nldc #{:X}\nstnl -1\nldc #{:X}\nrunp\n",
                                           from_start(second_workspace), from_start(second_workspace | 1)) +
                                   process_of(all.directions[i].sent, false, "s") + "second:\n" +
                                   process_of(all.directions[1 - i].received, true, "r"),
                               from_start(0xb00));
        NodeWorld::put(*nodes[i], programs[i]);
        std::array<std::uint8_t, 64> message;
        std::iota(message.begin(), message.end(), std::uint8_t{1});
        nodes[i]->core().copy_to_memory(send_buffer, message);
        watchers[i].emplace(nodes[i]->core());
        for (const auto& [label, address] : programs[i].labels)
            watchers[i]->times[address];
    }
    hardware::Link& link = world.connect(*nodes[0], 1, *nodes[1], 1, all.timing);
    for (const LinkFault& each : shifted(all.faults, began))
        link.suffer(each);
    for (transputer::Node* each : nodes)
        world.boot(world.host(*each), from_start(0xb00), from_start(first_workspace));
    world.run();
    REQUIRE_EQ(*watchers[0]->times[programs[0]["s0"]], *watchers[1]->times[programs[1]["s0"]]);
    began = *watchers[0]->times[programs[0]["s0"]];
    GoingOn times;
    for (const std::size_t direction : {0u, 1u})
        for (const bool receives : {false, true}) {
            const std::size_t node = receives ? 1 - direction : direction;
            const LinkCase::Direction& uses = all.directions[direction];
            const std::size_t count = (receives ? uses.received : uses.sent).size();
            for (std::size_t i = 1; i <= count; ++i)
                if (const auto at = watchers[node]->times[programs[node][fmt::format("{}{}", "sr"[receives], i)]])
                    times[direction][receives].push_back(*at - began);
            if (!uses.received.empty() && times[direction][1].size() == uses.received.size())
                for (std::uint32_t i = 0; i < uses.received.back().bytes; ++i)
                    REQUIRE_EQ(nodes[1 - direction]->core().memory().byte(receive_buffer + i), i + 1);
        }
    return times;
}

std::string times_as_text(const GoingOn& times) {
    std::string text;
    for (const auto& direction : times)
        for (const auto& end : direction) {
            for (const Time each : end)
                text += fmt::format("{} ", each.count());
            text += "| ";
        }
    return text;
}

Time beginning_of_processes() {
    Time began{};
    on_nodes({.timing = {}, .directions = {}}, began);
    return began;
}

constexpr LinkTiming link_timings[] = {
    {.bits_per_second = 20'000'000},
    {.bits_per_second = 10'000'000},
    {.bits_per_second = 5'000'000},
    {.bits_per_second = 20'000'000,
     .wire_delay = duration_of(hardware::Crossbar::crossing_delay, 100 * std::int64_t{20'000'000})},
    {.bits_per_second = 10'000'000, .overlapped_acknowledge = false}};

} // namespace

TEST_CASE("in and out of 1 to 64 bytes take the picosecond that two C++ processes take") {
    Time began = beginning_of_processes();
    for (const LinkTiming& timing : link_timings)
        for (std::uint32_t bytes = 1; bytes <= 64; bytes += bytes < 12 ? 1 : 13)
            for (const std::array<std::uint32_t, 2> cycles :
                 {std::array{200u, 200u}, {200u, 2900u}, {2900u, 200u}, {200u, 213u}})
                for (const bool both_ways : {false, true}) {
                    CAPTURE(bytes);
                    CAPTURE(cycles[0]);
                    CAPTURE(both_ways);
                    LinkCase all{.timing = timing, .directions = {}};
                    all.directions[0] = {{{cycles[0], bytes}, {200, bytes}}, {{cycles[1], bytes}, {130, bytes}}};
                    if (both_ways && bytes > 1) // see below
                        all.directions[1] = {{{cycles[0] + 30, bytes}}, {{cycles[1], bytes}}};
                    REQUIRE_EQ(times_as_text(on_nodes(all, began)), times_as_text(on_processors(all)));
                }
}

TEST_CASE("random communications by a link take the picosecond that C++ processes take, whatever is lost") {
    Time began = beginning_of_processes();
    int stuck = 0;
    for (const std::uint64_t seed : seeds(200)) {
        INFO(replay(seed));
        RandomStream random(seed, "link of nodes");
        LinkCase all{.timing = link_timings[random.below(std::size(link_timings))], .directions = {}};
        all.memory_cycles = random.chance(0.5) ? 3 : 3 + static_cast<int>(random.below(4));
        // An `in` of one byte that has come already gives way to ready processes, while a C++ process goes on. So
        // single bytes are sent only where no other process is ready.
        const std::uint32_t ways = 1 + random.below(2), fewest = ways;
        for (LinkCase::Direction& direction : std::span(all.directions).first(ways))
            for (std::uint32_t i = random.below(5); i > 0; --i) {
                const std::uint32_t bytes = fewest + random.below(random.chance(0.5) ? 5 : 65 - fewest);
                direction.sent.push_back({least_cycles + random.below(random.chance(0.5) ? 60 : 2000), bytes});
                direction.received.push_back({least_cycles + random.below(random.chance(0.5) ? 60 : 2000), bytes});
            }
        if (random.chance(0.5)) {
            const Time from{1000 * std::int64_t{random.below(200'000)}};
            if (random.chance(0.5))
                all.faults.push_back({.kind = LinkFault::Kind::loses_acknowledge, .from = from});
            else
                all.faults.push_back({.from = from, .until = from + Time{1000 * (1 + random.below(1500))}});
        }
        const GoingOn times = on_nodes(all, began);
        CHECK_EQ(times_as_text(times), times_as_text(on_processors(all)));
        for (std::size_t d : {0u, 1u})
            stuck += times[d][0].size() < all.directions[d].sent.size();
    }
    if (all_seeds())
        CHECK_GT(stuck, 20);
}
