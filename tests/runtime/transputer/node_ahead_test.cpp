// Tests that an emulated transputer runs ahead while its links rest, and is seen in its present state.

#include "node_world.hpp"

#include "runtime/channel.hpp"
#include "runtime/random.hpp"
#include "runtime/timer.hpp"
#include "tests/seeds.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>

#include <chrono>
#include <string>
#include <vector>

using namespace placedpar;
using namespace placedpar::test;
using namespace std::chrono_literals;

namespace {

/// A process of high priority takes bytes from link 1. Two of low priority communicate: one counts the messages in
/// workspace word 1, the other notes the clock in word 2. Each byte is stored with the count and the clock.
const std::string busy_at_both_priorities = fmt::format(
    "ldc 0\nsttimer\nmint\nldc #{0:X}\nstnl 0\n"
    "ldc takes\nldc #{1:X}\nstnl -1\nldc #{1:X}\nrunp\n"
    "ldc sends\nldc #{2:X}\nstnl -1\nldc #{2:X} + 1\nrunp\n"
    "ldc counts\nldc #{3:X}\nstnl -1\nldc #{3:X} + 1\nrunp\nstopp\n"
    "takes: ldc #{4:X}\nstl 1\n"
    "again: ldlp 2\nldc #{5:X}\nldc 1\nin\nldl 2\nldl 1\nstnl 0\nldtimer\nldl 1\nstnl 1\nldc #{3:X}\nldnl 1\nldl 1\n"
    "stnl 2\nldl 1\nldnlp 3\nstl 1\nj again\n"
    "sends: ldtimer\nstl 2\nldc #{0:X}\nldl 2\noutword\nj sends\n"
    "counts: ldlp 3\nldc #{0:X}\nldc 4\nin\nldl 1\nadc 1\nstl 1\nj counts\n",
    from_start(0x100), from_start(0x840), from_start(0x880), from_start(0x8c0), from_start(0x1000), from_start(0x14));

/// What is seen of the node during the run.
struct Seen {
    std::vector<std::uint64_t> instructions;
    std::vector<Time> local_times;
    std::vector<std::uint32_t> counts;
    std::vector<std::uint8_t> memory;
    std::uint64_t events = 0;
    bool operator==(const Seen& other) const {
        return instructions == other.instructions && local_times == other.local_times && counts == other.counts &&
               memory == other.memory;
    }
};

/// Runs the node while bytes come at some times. Looks at it at other times, which are in no instruction's half cycle.
Seen seen_with(const std::vector<Time>& bytes, const std::vector<Time>& looks, Time end, bool one_by_one) {
    NodeWorld world;
    transputer::Node& node = world.node("n", {});
    if (one_by_one)
        node.run_instruction_by_instruction();
    ScriptedEnd& sender = world.host(node, 1);
    for (const Time at : bytes)
        sender.will_give(at, {7});
    world.run_at_boot(node, busy_at_both_priorities);
    Seen seen;
    world.simulation.process("looks", [&] {
        for (const Time at : looks) {
            wait_for(at - Kernel::here().now());
            seen.instructions.push_back(node.core().instructions());
            seen.local_times.push_back(node.core().local_time());
            seen.counts.push_back(word_at(node, 0x8c4));
        }
        seen.events = Kernel::here().future().happened();
    });
    world.run(end);
    const auto memory = node.core().memory().bytes(0, 8192);
    seen.memory.assign(memory.begin(), memory.end());
    return seen;
}

std::vector<Time> random_times(RandomStream& random, std::size_t count, std::uint32_t most_pause_ns) {
    std::vector<Time> result;
    for (Time at = 20us; result.size() < count; result.push_back(at + Time{7}))
        at += std::chrono::nanoseconds{1 + random.below(most_pause_ns)};
    return result;
}

} // namespace

TEST_CASE("a process of high priority that waits for a link does not make each communication of others an event") {
    const Seen seen = seen_with({}, {20ms}, 21ms, false);
    CHECK_GT(seen.counts.at(0), 2000);
    CHECK_LT(seen.events, 200);
    const Seen disturbed = seen_with({5ms, 10ms, 15ms}, {20ms}, 21ms, false);
    CHECK_LT(disturbed.events, 400);
}

TEST_CASE("a transputer that has run ahead is seen in its present state, and links find it in this state") {
    for (const std::uint64_t seed : seeds(25)) {
        INFO(replay(seed));
        RandomStream random(seed, "moments");
        const std::vector<Time> bytes = random_times(random, 1 + random.below(30), 200'000);
        const std::vector<Time> looks = random_times(random, 1 + random.below(30), 200'000);
        const Seen usual = seen_with(bytes, looks, 4ms, false);
        CHECK(usual == seen_with(bytes, looks, 4ms, true));
    }
}
