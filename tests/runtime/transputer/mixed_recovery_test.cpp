// Tests that a C++ process gives up messages to and from a transputer's program as it does those of C++ processes.

#include "node_world.hpp"

#include "runtime/channel.hpp"
#include "runtime/executive.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/random.hpp"
#include "runtime/recovery.hpp"
#include "runtime/timer.hpp"
#include "runtime/transputer/message_end.hpp"
#include "tests/seeds.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>

using namespace placedpar;
using namespace placedpar::test;

namespace {

constexpr std::size_t words = 16;
using RecoveredMessage = std::array<std::int32_t, words>;
constexpr std::uint32_t program_code_at = from_start(0x300), program_workspace_at = from_start(0x200);

/// A process attempts to output or input a message; its partner does the other, without a time-out. After a failure the
/// process resets its end, and attempts again.
struct AttemptCase {
    hardware::LinkTiming timing;
    bool process_outputs;
    std::uint32_t process_cycles, partner_cycles; ///< before they begin
    Time patience;
};

/// What has become of an attempt, and when the partner went on.
struct AttemptResult {
    std::string of_process;
    std::optional<Time> partner;
};

void attempt(const AttemptCase& c, Channel<RecoveredMessage>& channel, Time began, std::string& text) {
    wait_until(began);
    compute(Cycles{c.process_cycles});
    for (int i = 0; i < 2; ++i) {
        RecoveredMessage message{};
        message.fill(7);
        const Time deadline = Kernel::here().now() + c.patience;
        const bool done = c.process_outputs ? output_or_fail(channel.out(), message, deadline)
                                            : input_or_fail(channel.in(), message, deadline);
        text += fmt::format("{} at {}", done ? "done" : "failed", (Kernel::here().now() - began).count());
        if (done)
            return;
        const std::uint64_t bytes = c.process_outputs ? reset(channel.out()) : reset(channel.in());
        text += fmt::format(" after {} bytes, reset at {}; ", bytes, (Kernel::here().now() - began).count());
    }
}

hardware::Processor& processor(NodeWorld& world) {
    return world.simulation.add<hardware::Processor>("t", 20'000'000, Cycles{0}, hardware::Memory{.access = Cycles{3}});
}

AttemptResult with_process(const AttemptCase& c, Time began) {
    NodeWorld world;
    AttemptResult result;
    hardware::Processor &here = processor(world), &there = processor(world);
    auto& link = world.simulation.add<hardware::Link>(c.timing);
    here.has_link(link);
    there.has_link(link);
    Channel<RecoveredMessage> channel("c", c.process_outputs ? link.from_a_to_b() : link.from_b_to_a());
    world.simulation.process(
        "process", [&] { attempt(c, channel, began, result.of_process); }, &here);
    world.simulation.process(
        "partner",
        [&] {
            wait_until(began);
            compute(Cycles{c.partner_cycles});
            if (c.process_outputs)
                channel.in().input();
            else
                channel.out().output({});
            result.partner = Kernel::here().now() - began;
        },
        &there);
    world.run(began + std::chrono::milliseconds{1});
    return result;
}

/// Returns the program that waits, and then inputs from link 1 or outputs to it.
std::string partner_program(const AttemptCase& c) {
    const std::string operands =
        fmt::format("ldlp 1\nldc #{:X}\nldc {}\n", from_start(c.process_outputs ? 0x14 : 0x04), 4 * words);
    const auto taken = static_cast<std::uint32_t>(transputer::assemble(operands).bytes.size());
    std::string text = "begin: ";
    for (std::uint32_t i = taken; i < c.partner_cycles; ++i)
        text += "ldc 0\n";
    return text + operands + (c.process_outputs ? "in" : "out") + "\ndone: ldc 0\nstopp\n";
}

/// `began`: when the program begins; becomes the time at which it has begun.
AttemptResult with_program(const AttemptCase& c, Time& began) {
    NodeWorld world;
    AttemptResult result;
    transputer::Node& node = world.node("n", {});
    const transputer::Assembly program = transputer::assemble(partner_program(c), program_code_at);
    NodeWorld::put(node, program);
    InstructionTimes watcher(node.core());
    watcher.times[program["begin"]];
    watcher.times[program["done"]];
    hardware::Processor& here = processor(world);
    transputer::MessageEnd end("n");
    hardware::Link& link = world.connect(end, node.end(1), c.timing);
    here.has_link(link);
    node.has_link(link);
    Channel<RecoveredMessage> channel("c");
    if (c.process_outputs)
        end.carry_outputs(channel);
    else
        end.carry_inputs(channel);
    world.boot(world.host(node), program_code_at, program_workspace_at);
    world.simulation.process(
        "process", [&] { attempt(c, channel, began, result.of_process); }, &here);
    world.run(began + std::chrono::milliseconds{1});
    began = *watcher.times[program["begin"]];
    if (const auto done = watcher.times[program["done"]])
        result.partner = *done - began;
    return result;
}

AttemptCase random_attempt(RandomStream& random) {
    constexpr std::int64_t speeds[] = {20'000'000, 10'000'000, 5'000'000};
    const std::uint32_t at_most = random.chance(0.5) ? 200 : 2000;
    AttemptCase c{.timing = {.bits_per_second = speeds[random.below(3)]},
                  .process_outputs = random.chance(0.5),
                  .process_cycles = 40 + random.below(at_most),
                  .partner_cycles = 40 + random.below(at_most),
                  .patience = Time{1} + std::chrono::nanoseconds{random.below(at_most * 100)}};
    c.timing.overlapped_acknowledge = random.chance(0.7);
    return c;
}

} // namespace

TEST_CASE("a process gives up a message to or from a transputer's program as one to or from a process") {
    Time began{};
    with_program({.timing = {}, .process_outputs = true, .process_cycles = 40, .partner_cycles = 40, .patience = {}},
                 began);
    int done = 0, failed = 0, in_the_middle = 0;
    for (const std::uint64_t seed : seeds(1500)) {
        INFO(replay(seed));
        RandomStream random(seed, "mixed recovery");
        const AttemptCase c = random_attempt(random);
        Time seen = began;
        const AttemptResult found = with_program(c, seen), wanted = with_process(c, began);
        CHECK_EQ(seen, began);
        CHECK_EQ(found.of_process, wanted.of_process);
        CHECK_EQ(found.partner.value_or(Time{}).count(), wanted.partner.value_or(Time{}).count());
        done += wanted.of_process.starts_with("done");
        failed += wanted.of_process.starts_with("failed");
        const std::string first = wanted.of_process.substr(0, wanted.of_process.find(';'));
        in_the_middle += first.starts_with("failed") && first.find(" after 0 bytes") == std::string::npos;
    }
    if (all_seeds()) {
        CHECK_GT(done, 200);
        CHECK_GT(failed, 200);
        CHECK_GT(in_the_middle, 100);
    }
}
