// Tests that a ring in which emulated transputers and C++ processes alternate gives the values and the times of a ring
// of C++ processes, whichever nodes are emulated.

#include "node_world.hpp"

#include "runtime/channels.hpp"
#include "runtime/executive.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/random.hpp"
#include "runtime/timer.hpp"
#include "runtime/transputer/message_end.hpp"
#include "tests/seeds.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

using namespace placedpar;
using namespace placedpar::test;

namespace {

constexpr std::size_t words_of_message = 3;
using RingMessage = std::array<std::int32_t, words_of_message>;
constexpr std::uint32_t least_work = 40; ///< cycles

/// A ring of nodes. The first node sends a message, which goes around several times; each node adds a number to its
/// first word.
struct RingCase {
    hardware::LinkTiming timing;
    struct RingNode {
        bool is_emulated;
        std::int32_t added;                             ///< 0 to 15
        std::vector<std::array<std::uint32_t, 2>> work; ///< by round: cycles before the input, before the output
    };
    std::vector<RingNode> nodes;
    std::size_t rounds = 1;

    bool is_first(std::size_t node) const { return node == 0; }
};

/// By node: when it went on after each communication, and the message that it received last.
struct RingResult {
    std::vector<std::vector<Time>> times;
    std::vector<RingMessage> last;
    bool operator==(const RingResult&) const = default;
};

constexpr std::uint32_t ring_code = from_start(0x300), ring_workspace = from_start(0x200); // on the chip, as all code
constexpr std::uint32_t ring_buffer = 0x204;                                               ///< word 1 of the workspace

/// Returns instructions of one cycle each.
std::string work_of(std::uint32_t cycles) {
    std::string text;
    for (; cycles > 0; --cycles)
        text += "ldc 0\n";
    return text;
}

/// Returns the instructions of a communication, and of the cycles of work before it.
std::string ring_step(std::uint32_t cycles, std::uint32_t channel, const char* operation) {
    const std::string operands = fmt::format("ldlp 1\nldc #{:X}\nldc {}\n", channel, 4 * words_of_message);
    const auto taken = static_cast<std::uint32_t>(transputer::assemble(operands).bytes.size());
    return work_of(cycles - taken) + operands + operation;
}

/// Link 1 leads from the node before, link 2 to the next one. The label after communication i is `ti`.
std::string ring_program(const RingCase& ring, std::size_t node) {
    const RingCase::RingNode& own = ring.nodes[node];
    const std::string add = fmt::format("ldl 1\nadc {}\nstl 1\n", own.added); // 2 + 1 + 1 cycles
    std::string text = "begin: ";
    int number = 0;
    const auto label = [&] { text += fmt::format("\nt{}: ", number++); };
    for (std::size_t round = 0; round < ring.rounds; ++round) {
        const std::string in = ring_step(own.work[round][0], from_start(0x14), "in");
        const std::string out = add + ring_step(own.work[round][1] - 4, from_start(0x08), "out");
        text += ring.is_first(node) ? out : in;
        label();
        text += ring.is_first(node) ? in : out;
        label();
    }
    return text + "ldc 0\nstopp\n";
}

void be_ring_node(const RingCase& ring, std::size_t node, Input<RingMessage> from, Output<RingMessage> to, Time began,
                  RingResult& result) {
    const RingCase::RingNode& own = ring.nodes[node];
    RingMessage message{};
    const auto note = [&] { result.times[node].push_back(Kernel::here().now() - began); };
    const auto send = [&](std::size_t round) {
        compute(Cycles{own.work[round][1]});
        message[0] += own.added;
        to.output(message);
        note();
    };
    for (std::size_t round = 0; round < ring.rounds; ++round) {
        if (ring.is_first(node))
            send(round);
        compute(Cycles{own.work[round][0]});
        message = result.last[node] = from.input();
        note();
        if (!ring.is_first(node))
            send(round);
    }
}

struct RingEnd {
    explicit RingEnd(Kernel&) {}
    transputer::MessageEnd end{"code"};
};

/// A ring under construction and in its run.
class RunningRing {
public:
    /// `began`: when the programs of emulated nodes begin.
    RunningRing(const RingCase& ring, Time began) : ring_(ring), began_(began) {
        const std::size_t count = ring.nodes.size();
        nodes_.resize(count);
        processors_.resize(count);
        programs_.resize(count);
        for (std::size_t i = 0; i < count; ++i)
            ring.nodes[i].is_emulated ? emulate(i) : place(i);
        for (std::size_t i = 0; i < count; ++i)
            channels_.emplace_back(fmt::format("c{}", i));
        for (std::size_t i = 0; i < count; ++i)
            connect(i, (i + 1) % count);
    }

    /// `began` becomes the time at which the first emulated node began.
    RingResult run(Time& began) {
        const std::size_t count = ring_.nodes.size();
        RingResult result{std::vector<std::vector<Time>>(count), std::vector<RingMessage>(count)};
        Channels<int> begin("begin", count);
        for (std::size_t i = 0; i < count; ++i)
            if (processors_[i])
                world_.simulation.process(
                    fmt::format("p{}", i),
                    [&, i] {
                        begin[i].in().input();
                        be_ring_node(ring_, i, channels_[(i + count - 1) % count].in(), channels_[i].out(), began_,
                                     result);
                    },
                    processors_[i]);
        world_.simulation.process("begins", [&] {
            wait_until(began_);
            for (std::size_t i = 0; i < count; ++i)
                if (processors_[i])
                    begin[i].out().output(0);
        });
        world_.run();
        std::size_t watcher = 0;
        for (std::size_t i = 0; i < count; ++i)
            if (nodes_[i])
                began = read(i, watchers_[watcher++], result);
        return result;
    }

private:
    void emulate(std::size_t i) {
        nodes_[i] = &world_.node(fmt::format("n{}", i), {});
        programs_[i] = transputer::assemble(ring_program(ring_, i), ring_code);
        NodeWorld::put(*nodes_[i], programs_[i]);
        InstructionTimes& watcher = watchers_.emplace_back(nodes_[i]->core());
        for (const auto& [label, address] : programs_[i].labels)
            watcher.times[address];
        world_.boot(world_.host(*nodes_[i]), ring_code, ring_workspace);
    }

    void place(std::size_t i) {
        processors_[i] = &world_.simulation.add<hardware::Processor>("t", 20'000'000, Cycles{0},
                                                                     hardware::Memory{.access = Cycles{3}});
    }

    void connect(std::size_t i, std::size_t next) {
        hardware::Link* link = nullptr;
        if (nodes_[i] && nodes_[next]) {
            world_.connect(*nodes_[i], 2, *nodes_[next], 1, ring_.timing);
            return;
        }
        if (processors_[i] && processors_[next]) {
            link = &world_.simulation.add<hardware::Link>(ring_.timing);
            channels_[i].put_on(link->from_a_to_b());
        } else {
            transputer::MessageEnd& end = world_.simulation.add<RingEnd>().end;
            link = nodes_[i] ? &world_.connect(nodes_[i]->end(2), end, ring_.timing)
                             : &world_.connect(end, nodes_[next]->end(1), ring_.timing);
            nodes_[i] ? end.carry_inputs(channels_[i]) : end.carry_outputs(channels_[i]);
        }
        for (const std::size_t each : {i, next})
            nodes_[each] ? nodes_[each]->has_link(*link) : processors_[each]->has_link(*link);
    }

    Time read(std::size_t i, InstructionTimes& watcher, RingResult& result) {
        const Time began = *watcher.times[programs_[i]["begin"]];
        for (std::size_t k = 0; k < 2 * ring_.rounds; ++k)
            if (const auto at = watcher.times[programs_[i][fmt::format("t{}", k)]])
                result.times[i].push_back(*at - began);
        for (std::size_t k = 0; k < words_of_message; ++k)
            result.last[i][k] =
                static_cast<std::int32_t>(word_at(*nodes_[i], ring_buffer + 4 * static_cast<std::uint32_t>(k)));
        if (!ring_.is_first(i)) // it has added its number since
            result.last[i][0] -= ring_.nodes[i].added;
        return began;
    }

    const RingCase& ring_;
    Time began_;
    NodeWorld world_;
    std::vector<transputer::Node*> nodes_;
    std::vector<hardware::Processor*> processors_;
    std::vector<transputer::Assembly> programs_;
    std::deque<InstructionTimes> watchers_;
    std::deque<Channel<RingMessage>> channels_; ///< from node i to the next one
};

RingCase random_ring(RandomStream& random) {
    constexpr std::int64_t speeds[] = {20'000'000, 10'000'000, 5'000'000};
    RingCase ring{.timing = {.bits_per_second = speeds[random.below(3)]}, .nodes = {}, .rounds = 1 + random.below(4)};
    for (std::uint32_t nodes = 2 + random.below(4); nodes > 0; --nodes) {
        RingCase::RingNode& node = ring.nodes.emplace_back(
            RingCase::RingNode{random.chance(0.5), static_cast<std::int32_t>(random.below(16)), {}});
        for (std::size_t round = 0; round < ring.rounds; ++round)
            node.work.push_back({least_work + random.below(200), least_work + random.below(200)});
    }
    return ring;
}

std::string text_of_ring(const RingResult& result) {
    std::string text;
    for (std::size_t i = 0; i < result.times.size(); ++i) {
        for (const Time each : result.times[i])
            text += fmt::format("{} ", each.count());
        for (const std::int32_t each : result.last[i])
            text += fmt::format("({})", each);
        text += "\n";
    }
    return text;
}

} // namespace

TEST_CASE("rings of transputers and C++ processes give the values and the times of a ring of C++ processes") {
    Time began{};
    RingCase one{.timing = {}, .nodes = {{true, 1, {{least_work, least_work}}}, {true, 1, {{least_work, least_work}}}}};
    RunningRing(one, began).run(began);
    int mixed = 0;
    for (const std::uint64_t seed : seeds(300)) {
        INFO(replay(seed));
        RandomStream random(seed, "mixed ring");
        RingCase ring = random_ring(random);
        Time seen = began;
        const RingResult result = RunningRing(ring, began).run(seen);
        CHECK_EQ(seen, began);
        int emulated = 0;
        for (RingCase::RingNode& each : ring.nodes)
            emulated += std::exchange(each.is_emulated, false);
        mixed += emulated > 0 && emulated < static_cast<int>(ring.nodes.size());
        const RingResult wanted = RunningRing(ring, began).run(seen);
        CHECK_EQ(text_of_ring(result), text_of_ring(wanted));
        CHECK_EQ(wanted.times[0].size(), 2 * ring.rounds);
    }
    if (all_seeds())
        CHECK_GT(mixed, 150);
}
