// Tests that instructions of emulated transputers use a link in the same time as C++ processes on processors, to the
// picosecond: two transputers, and a transputer with C++ processes at the other end of its link.

#include "node_world.hpp"

#include "runtime/alternation.hpp"
#include "runtime/channels.hpp"
#include "runtime/executive.hpp"
#include "runtime/hardware/crossbar.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/random.hpp"
#include "runtime/timer.hpp"
#include "runtime/transputer/message_end.hpp"
#include "tests/seeds.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>

#include <algorithm>
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
    bool alternates = false;            ///< receivers input in an ALT whose only guard is the channel
    std::vector<LinkFault> faults = {}; ///< times count from the beginning of the processes
};

/// The times at which the processes went on after each use: senders and receivers of both directions. A process that
/// was stuck has fewer.
using GoingOn = std::array<std::array<std::vector<Time>, 2>, 2>;

struct CountedBytes {
    std::uint32_t bytes;
    WireForm wire_form() const { return WireForm(bytes); }
};

/// The number of bytes of the next message that a C++ process inputs from a transputer.
std::uint32_t expected_bytes = 0;

/// The bytes of each message: 1, 2, 3 ...
std::vector<std::uint8_t> message_of(std::size_t bytes) {
    std::vector<std::uint8_t> message(bytes);
    std::iota(message.begin(), message.end(), std::uint8_t{1});
    return message;
}

} // namespace

template <>
struct placedpar::ByteForm<CountedBytes> {
    static void write(const CountedBytes& message, MessageBytes& to) { to = message_of(message.bytes); }
    static std::uint32_t next_part(std::span<const std::uint8_t> so_far) { return so_far.empty() ? expected_bytes : 0; }
    static CountedBytes read(std::span<const std::uint8_t> bytes) {
        CHECK(std::ranges::equal(bytes, message_of(expected_bytes)));
        return {expected_bytes};
    }
};

namespace {

std::vector<LinkFault> shifted(std::vector<LinkFault> faults, Time by) {
    for (LinkFault& fault : faults) {
        fault.from = later(fault.from, by);
        fault.until = later(fault.until, by);
    }
    return faults;
}

/// The end of a link at which C++ processes use it.
struct MessageEndOfTest {
    explicit MessageEndOfTest(Kernel&) {}
    transputer::MessageEnd end{"n"};
};

hardware::Processor& processor_for(Simulation& simulation, const LinkCase& all) {
    return simulation.add<hardware::Processor>("t", 20'000'000, Cycles{0},
                                               hardware::Memory{.access = Cycles{all.memory_cycles}});
}

/// Uses the link as a process at one end of a direction. Notes the times since `began`.
void use_link(const LinkCase& all, std::size_t direction, bool receives, Channel<CountedBytes>& channel, Time began,
              std::vector<Time>& times) {
    const LinkCase::Direction& uses = all.directions[direction];
    for (const LinkUse& each : receives ? uses.received : uses.sent) {
        compute(Cycles{each.cycles});
        expected_bytes = receives ? each.bytes : expected_bytes;
        if (receives && all.alternates)
            alt(on(channel.in(), [](const CountedBytes&) {}));
        else if (receives)
            channel.in().input();
        else
            channel.out().output({each.bytes});
        times.push_back(Kernel::here().now() - began);
    }
    compute(Cycles{13}); // ldc, stopp
}

GoingOn on_processors(const LinkCase& all) {
    Simulation simulation;
    GoingOn times;
    std::array<hardware::Processor*, 2> processors{&processor_for(simulation, all), &processor_for(simulation, all)};
    auto& link = simulation.add<hardware::Link>(all.timing);
    for (const LinkFault& each : all.faults)
        link.suffer(each);
    for (auto* each : processors)
        each->has_link(link);
    std::deque<Channel<CountedBytes>> channels;
    channels.emplace_back("there", link.from_a_to_b());
    channels.emplace_back("back", link.from_b_to_a());
    const auto use = [&](std::size_t direction, bool receives) {
        simulation.process(
            "uses the link",
            [&, receives, direction] {
                use_link(all, direction, receives, channels[direction], Time{0}, times[direction][receives]);
            },
            processors[receives ? 1 - direction : direction]);
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
std::string process_of(const LinkCase& all, std::size_t direction, bool receives) {
    const LinkCase::Direction& its = all.directions[direction];
    const std::vector<LinkUse>& uses = receives ? its.received : its.sent;
    const std::string name = receives ? "r" : "s";
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
        if (receives && all.alternates)
            text += fmt::format("alt\nldc #{0:X}\nldc 1\nenbc\naltwt\nldc #{0:X}\nldc 1\nldc 0\ndisc\naltend\n",
                                from_start(0x14));
        text += operands + (receives ? "in\n" : "out\n");
    }
    return text + fmt::format("{}{}: ldc 0\nstopp\n", name, number);
}

/// A transputer whose code uses its link 1 as node `number` of a case.
class EmulatedEnd {
public:
    EmulatedEnd(NodeWorld& world, const LinkCase& all, std::size_t number)
        : node(world.node("n", {.memory = 8192, .timing = {.memory_cycles = all.memory_cycles}})), all_(all),
          number_(number), program_(program_of(all, number)), watcher_(node.core()) {
        NodeWorld::put(node, program_);
        node.core().copy_to_memory(send_buffer, message_of(64));
        for (const auto& [label, address] : program_.labels)
            watcher_.times[address];
        world.boot(world.host(node), from_start(0xb00), from_start(first_workspace));
    }
    EmulatedEnd(const EmulatedEnd&) = delete;

    /// Returns when the processes began.
    Time began() { return *watcher_.times[program_["s0"]]; }

    /// Adds the times of the node's two processes since they began. Checks the last message that came.
    void add_times(GoingOn& times) {
        for (const bool receives : {false, true}) {
            const std::size_t direction = receives ? 1 - number_ : number_;
            const LinkCase::Direction& uses = all_.directions[direction];
            const std::vector<LinkUse>& own = receives ? uses.received : uses.sent;
            for (std::size_t i = 1; i <= own.size(); ++i)
                if (const auto at = watcher_.times[program_[fmt::format("{}{}", "sr"[receives], i)]])
                    times[direction][receives].push_back(*at - began());
            if (receives && !own.empty() && times[direction][1].size() == own.size())
                for (std::uint32_t i = 0; i < own.back().bytes; ++i)
                    REQUIRE_EQ(node.core().memory().byte(receive_buffer + i), i + 1);
        }
    }

    transputer::Node& node;

private:
    static Assembly program_of(const LinkCase& all, std::size_t number) {
        return assemble(fmt::format("ldc second\nldc #{:X}\nstnl -1\nldc #{:X}\nrunp\n", from_start(second_workspace),
                                    from_start(second_workspace | 1)) +
                            process_of(all, number, false) + "second:\n" + process_of(all, 1 - number, true),
                        from_start(0xb00));
    }

    const LinkCase& all_;
    std::size_t number_;
    Assembly program_;
    InstructionTimes watcher_;
};

/// Returns the times since the first instruction of the processes of both nodes. `began` becomes this time.
GoingOn on_nodes(const LinkCase& all, Time& began) {
    NodeWorld world;
    EmulatedEnd first(world, all, 0), second(world, all, 1);
    hardware::Link& link = world.connect(first.node, 1, second.node, 1, all.timing);
    for (const LinkFault& each : shifted(all.faults, began))
        link.suffer(each);
    world.run();
    REQUIRE_EQ(first.began(), second.began());
    began = first.began();
    GoingOn times;
    first.add_times(times);
    second.add_times(times);
    return times;
}

/// Returns the times on a transputer and a processor with C++ processes. The transputer is the node of this number. The
/// processes on the processor begin at `began`, as those of the transputer do.
GoingOn on_both(const LinkCase& all, std::size_t number, Time began) {
    NodeWorld world;
    GoingOn times;
    EmulatedEnd emulated(world, all, number);
    hardware::Processor& processor = processor_for(world.simulation, all);
    auto& there = world.simulation.add<MessageEndOfTest>();
    hardware::Link& link = number == 0 ? world.connect(emulated.node.end(1), there.end, all.timing)
                                       : world.connect(there.end, emulated.node.end(1), all.timing);
    for (const LinkFault& each : shifted(all.faults, began))
        link.suffer(each);
    emulated.node.has_link(link);
    processor.has_link(link);
    std::deque<Channel<CountedBytes>> channels;
    Channels<int> begin("begin", 2);
    for (const bool receives : {false, true}) { // a processor's sender comes first in its queue
        Channel<CountedBytes>& channel = channels.emplace_back("channel");
        receives ? there.end.carry_inputs(channel) : there.end.carry_outputs(channel);
        const std::size_t direction = receives ? number : 1 - number;
        world.simulation.process(
            "uses the link",
            [&, receives, direction] {
                begin[receives].in().input();
                use_link(all, direction, receives, channel, began, times[direction][receives]);
            },
            &processor);
    }
    world.simulation.process("begins", [&] {
        wait_until(began);
        begin[0].out().output(0);
        begin[1].out().output(0);
    });
    world.run();
    REQUIRE_EQ(emulated.began(), began);
    emulated.add_times(times);
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
    test::EveryNth some(9);
    for (const LinkTiming& timing : link_timings)
        for (std::uint32_t bytes = 1; bytes <= 64; bytes += bytes < 12 ? 1 : 13)
            for (const std::array<std::uint32_t, 2> cycles :
                 {std::array{200u, 200u}, {200u, 2900u}, {2900u, 200u}, {200u, 213u}})
                for (const bool both_ways : {false, true}) {
                    if (some.passes_over())
                        continue;
                    CAPTURE(bytes);
                    CAPTURE(cycles[0]);
                    CAPTURE(both_ways);
                    LinkCase all{.timing = timing, .directions = {}};
                    all.directions[0] = {{{cycles[0], bytes}, {200, bytes}}, {{cycles[1], bytes}, {130, bytes}}};
                    if (both_ways && bytes > 1) // see below
                        all.directions[1] = {{{cycles[0] + 30, bytes}}, {{cycles[1], bytes}}};
                    const std::string wanted = times_as_text(on_processors(all));
                    REQUIRE_EQ(times_as_text(on_nodes(all, began)), wanted);
                    REQUIRE_EQ(times_as_text(on_both(all, 0, began)), wanted);
                    REQUIRE_EQ(times_as_text(on_both(all, 1, began)), wanted);
                }
}

TEST_CASE("a process and a transputer that alternate on a link are ready when the first byte has come") {
    Time began = beginning_of_processes();
    for (const std::uint64_t seed : seeds(100)) {
        INFO(replay(seed));
        RandomStream random(seed, "alternation on a link");
        LinkCase all{
            .timing = link_timings[random.below(std::size(link_timings))], .directions = {}, .alternates = true};
        for (std::uint32_t i = 1 + random.below(4); i > 0; --i) {
            const std::uint32_t bytes = 1 + random.below(random.chance(0.5) ? 4 : 64);
            all.directions[0].sent.push_back({least_cycles + random.below(random.chance(0.5) ? 60 : 2000), bytes});
            all.directions[0].received.push_back({least_cycles + random.below(random.chance(0.5) ? 60 : 2000), bytes});
        }
        // Instructions and a C++ process take different times to alternate, so only like receivers are compared.
        CHECK_EQ(times_as_text(on_both(all, 0, began)), times_as_text(on_processors(all)));
        CHECK_EQ(times_as_text(on_both(all, 1, began)), times_as_text(on_nodes(all, began)));
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
        const std::string wanted = times_as_text(on_processors(all));
        CHECK_EQ(times_as_text(times), wanted);
        CHECK_EQ(times_as_text(on_both(all, 0, began)), wanted);
        CHECK_EQ(times_as_text(on_both(all, 1, began)), wanted);
        for (std::size_t d : {0u, 1u})
            stuck += times[d][0].size() < all.directions[d].sent.size();
    }
    if (all_seeds())
        CHECK_GT(stuck, 20);
}
