// Tests how emulated transputers are booted, halted and analysed.

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
using transputer::most_negative;
using transputer::Node;
using namespace std::chrono_literals;

namespace {

using ByteString = std::vector<std::uint8_t>;

ByteString word_bytes(std::uint32_t word) {
    return {static_cast<std::uint8_t>(word), static_cast<std::uint8_t>(word >> 8),
            static_cast<std::uint8_t>(word >> 16), static_cast<std::uint8_t>(word >> 24)};
}

ByteString joined(const std::vector<ByteString>& parts) {
    ByteString all;
    for (const ByteString& each : parts)
        all.insert(all.end(), each.begin(), each.end());
    return all;
}

ByteString poke_command(std::uint32_t address, std::uint32_t value) {
    return joined({{0}, word_bytes(address), word_bytes(value)});
}
ByteString peek_command(std::uint32_t address) { return joined({{1}, word_bytes(address)}); }

constexpr std::uint32_t memory_start = 0x70;

/// Returns what boots a node with this program of at most 255 bytes.
ByteString boot_stream(const std::string& source) {
    const Assembly program = assemble(source, from_start(memory_start));
    REQUIRE(program.bytes.size() >= 2);
    REQUIRE(program.bytes.size() < 256);
    return joined({{static_cast<std::uint8_t>(program.bytes.size())}, program.bytes});
}

/// Stores the registers that a boot passes, and the workspace, from W + 1 on.
const std::string stores_registers = "stl 1\nstl 2\nstl 3\nldlp 0\nstl 4\nldpri\nstl 5\nstopp";
/// Returns the offset of the workspace after a boot with this stream.
std::uint32_t workspace_after(const ByteString& stream) {
    return (memory_start + static_cast<std::uint32_t>(stream.size()) - 1 + 3) & ~3u;
}

/// A node with a host at each link.
struct ManyHosts {
    ManyHosts() : node(world.node("n", {})) {
        for (int link = 0; link < Node::links; ++link)
            hosts[static_cast<std::size_t>(link)] = &world.host(node, link);
    }
    NodeWorld world;
    Node& node;
    std::array<ScriptedEnd*, 4> hosts;
};

} // namespace

TEST_CASE("any link boots a node, with low priority, its workspace behind the code, and the channel in C") {
    for (const std::size_t link : {0u, 1u, 2u, 3u}) {
        ManyHosts all;
        const ByteString stream = boot_stream(stores_registers);
        all.hosts[link]->will_give(5us, stream);
        all.world.run();
        const std::uint32_t workspace = workspace_after(stream);
        CHECK(all.node.activity() == Node::Activity::booted);
        CHECK_EQ(word_at(all.node, workspace + 12), from_start(0x10 + 4 * static_cast<std::uint32_t>(link)));
        CHECK_EQ(word_at(all.node, workspace + 16), from_start(workspace));
        CHECK_EQ(word_at(all.node, workspace + 20), 1);
    }
}

TEST_CASE("a node that nobody boots listens for ever") {
    ManyHosts all;
    all.hosts[1]->will_give(1us, poke_command(from_start(0x200), 5));
    all.world.run();
    CHECK(all.node.activity() == Node::Activity::listening);
    CHECK_EQ(word_at(all.node, 0x200), 5);
    CHECK_EQ(all.node.core().instructions(), 0);
}

TEST_CASE("the first link that brings a byte boots the node, and the bytes of others wait for the program") {
    for (const Time later_by : {Time{0}, Time{1ns}, Time{400ns}, Time{20us}}) {
        CAPTURE(later_by.count());
        ManyHosts all;
        // Link 2 is the first of two that begin together.
        all.hosts[3]->will_give(5us + later_by, {9, 8, 7, 6});
        all.hosts[2]->will_give(5us, boot_stream("ajw 20\nldlp 1\nldc #8000001C\nldc 4\nin\nstopp"));
        all.world.run();
        CHECK(all.node.activity() == Node::Activity::booted);
        const std::uint32_t workspace = all.node.core().registers().workspace - most_negative;
        CHECK_EQ(word_at(all.node, workspace + 4), 0x06070809);
    }
    ManyHosts all; // now link 3 is the first
    all.hosts[3]->will_give(5us - 1ns, boot_stream(stores_registers));
    all.hosts[2]->will_give(5us, boot_stream(stores_registers));
    all.world.run();
    CHECK_EQ(word_at(all.node, workspace_after(boot_stream(stores_registers)) + 12), from_start(0x1C));
    CHECK(all.hosts[2]->given_at().empty());
}

TEST_CASE("hosts at any links read and write the memory in turn, and then one of them boots the node") {
    ManyHosts all;
    all.hosts[0]->will_give(0us, poke_command(from_start(0x400), 0x12345678));
    all.hosts[0]->will_give(0us, poke_command(from_start(0x404), 0x9abcdef0));
    all.hosts[1]->will_give(100us, peek_command(from_start(0x404)));
    all.hosts[2]->will_give(100us, peek_command(from_start(0x400)));
    all.hosts[2]->will_give(100us, peek_command(from_start(0x2000 + 0x404))); // the memory of 8 Kbyte wraps
    all.hosts[3]->will_give(200us, poke_command(from_start(0x408), 7));
    all.hosts[1]->will_give(300us, boot_stream(stores_registers));
    all.world.run();
    CHECK_EQ(all.hosts[1]->received(), word_bytes(0x9abcdef0));
    CHECK_EQ(all.hosts[2]->received(), joined({word_bytes(0x12345678), word_bytes(0x9abcdef0)}));
    CHECK(all.hosts[0]->received().empty());
    CHECK_EQ(word_at(all.node, 0x408), 7);
    CHECK(all.node.activity() == Node::Activity::booted);
}

TEST_CASE("a program that the host sends boots the neighbour, whose answer comes back to the host") {
    NodeWorld world;
    Node &root = world.node("root", {}), &other = world.node("other", {});
    ScriptedEnd& host = world.host(root);
    world.connect(root, 2, other, 3);
    // The neighbour takes a word from the link that booted it, doubles it, and outputs it there. C is the channel.
    const ByteString for_other =
        boot_stream("ajw 20\nstl 1\nstl 1\nstl 1\nldlp 2\nldl 1\nldc 4\nin\nldl 2\nldl 2\nsum\nstl 2\n"
                    "ldlp 2\nldl 1\nldnlp -4\nldc 4\nout\nstopp");
    // The second stage sends these bytes and a word to link 2, and what comes back to the host.
    const std::string second_stage =
        fmt::format("ldc code\nldc #80000008\nldc {}\nout\nldc 21\nstl 1\nldlp 1\nldc #80000008\nldc 4\nout\n"
                    "ldlp 1\nldc #80000018\nldc 4\nin\nldlp 1\nldc #80000000\nldc 4\nout\nstopp\ncode: ",
                    for_other.size());
    const ByteString stage = joined({assemble(second_stage, from_start(0x400)).bytes, for_other});
    // The first stage takes a length, and so many bytes to #80000400, where it goes on.
    host.will_give(0us,
                   boot_stream("ajw 20\nldlp 1\nldc #80000010\nldc 4\nin\nldc #80000400\nldc #80000010\nldl 1\nin\n"
                               "ldc #80000400\ngcall"));
    host.will_give(0us, joined({word_bytes(static_cast<std::uint32_t>(stage.size())), stage}));
    world.run();
    CHECK(other.activity() == Node::Activity::booted);
    CHECK_EQ(host.received(), word_bytes(42));
}

namespace {

/// A node that counts at W + 1 from 10 us on, and after each count at W + 2.
struct CountingNode {
    CountingNode() : node(world.node("n", {})), host(world.host(node)) {
        NodeWorld::put(node, assemble("ldc 0\nstl 1\nldc 0\nstl 2\nbegin: ldl 1\nadc 1\nstl 1\nldl 2\nadc 1\nstl 2\n"
                                      "j begin",
                                      from_start(0x200)));
        world.boot(host, from_start(0x200), from_start(0x800), 10us);
    }
    NodeWorld world;
    Node& node;
    ScriptedEnd& host;
};

} // namespace

TEST_CASE("a node that halts executes nothing more, however far it has run ahead") {
    std::optional<std::uint64_t> instructions;
    for (const bool one_by_one : {false, true}) {
        CountingNode counting;
        counting.node.halt_at(500us);
        if (one_by_one)
            counting.node.run_instruction_by_instruction();
        counting.world.run();
        CHECK(counting.node.activity() == Node::Activity::halted);
        const std::uint64_t executed = counting.node.core().instructions();
        CHECK_EQ(executed, instructions.value_or(executed));
        instructions = executed;
        CHECK_GE(counting.node.core().local_time(), 500us);
        CHECK_LT(counting.node.core().local_time(), 501us);
    }
    CHECK_GT(*instructions, 1000);
    CountingNode early; // halted before its boot
    early.node.halt_at(5us);
    early.world.run();
    CHECK_EQ(early.node.core().instructions(), 0);
}

TEST_CASE("a transfer that is under way when its node halts ends for the partner") {
    NodeWorld world;
    Node &a = world.node("a", {}), &b = world.node("b", {});
    world.connect(a, 1, b, 1);
    world.run_at_boot(a, "ldc #80000900\nldc #80000004\nldc 64\nout\nstopp");
    world.run_at_boot(b, "ldc #80000900\nldc #80000014\nldc 64\nin\nldc 1\nldc #80000a00\nstnl 0\nstopp");
    a.halt_at(45us); // in the middle
    world.run();
    CHECK_EQ(word_at(b, 0xa00), 1);
    CHECK_EQ(word_at(a, 0x04), from_start(0x801));
}

TEST_CASE("analyse stops a process at its next jump, and its registers are read by a peek") {
    std::optional<std::uint32_t> counted;
    for (const bool one_by_one : {false, true}) {
        CountingNode counting;
        counting.node.analyse_at(500us);
        if (one_by_one)
            counting.node.run_instruction_by_instruction();
        for (const std::uint32_t offset : {0x2Cu, 0x30u, 0x804u, 0x808u})
            counting.host.will_give(600us, peek_command(from_start(offset)));
        counting.world.run();
        CHECK(counting.node.activity() == Node::Activity::listening);
        const ByteString& seen = counting.host.received();
        REQUIRE_EQ(seen.size(), 16);
        const auto word = [&](std::size_t at) {
            return seen[at] | std::uint32_t{seen[at + 1]} << 8 | std::uint32_t{seen[at + 2]} << 16 |
                   std::uint32_t{seen[at + 3]} << 24;
        };
        CHECK_EQ(word(0), from_start(0x801));
        CHECK_EQ(word(4), from_start(0x204)); // at the beginning of the loop, to which it has jumped
        CHECK_EQ(word(8), word(12));          // both counts are equal there
        CHECK_GT(word(8), 100);
        CHECK_EQ(word(8), counted.value_or(word(8)));
        counted = word(8);
    }
}

TEST_CASE("after analyse a node is booted again: testpranal pushes TRUE, and A and B are the old Iptr and Wptr") {
    // The registers first: testpranal pushes onto them.
    // The workspace begins behind the code, which waiting would overwrite.
    const std::string program = "stl 1\nstl 2\nstl 3\ntestpranal\nstl 4\nstopp";
    const ByteString stream = boot_stream(program);
    const std::uint32_t workspace = workspace_after(stream);
    {
        ManyHosts all;
        all.hosts[0]->will_give(0us, stream);
        all.world.run();
        CHECK_EQ(word_at(all.node, workspace + 16), 0);
    }
    CountingNode counting;
    counting.node.analyse_at(500us);
    counting.host.will_give(600us, stream);
    counting.world.run();
    CHECK_EQ(word_at(counting.node, workspace + 16), 1);
    CHECK_EQ(word_at(counting.node, workspace + 4), from_start(0x204));
    CHECK_EQ(word_at(counting.node, workspace + 8), from_start(0x800));
}

TEST_CASE("analyse of a node whose process waits for a link keeps the channel word and frees the engine") {
    NodeWorld world;
    Node& node = world.node("n", {});
    ScriptedEnd& host = world.host(node);
    NodeWorld::put(node, assemble("ldc #80000900\nldc #80000010\nldc 4\nin\nstopp", from_start(0x200)));
    world.boot(host, from_start(0x200), from_start(0x800));
    node.analyse_at(500us);
    host.will_give(600us, joined({peek_command(from_start(0x10)), peek_command(from_start(0x2C))}));
    world.run();
    CHECK_EQ(host.received(), joined({word_bytes(from_start(0x801)), word_bytes(transputer::not_a_process)}));
}

TEST_CASE("a node that an error has stopped is analysed, too") {
    NodeWorld world;
    Node& node = world.node("n", {});
    ScriptedEnd& host = world.host(node);
    int told = 0;
    node.when_stopped([&] { ++told; });
    NodeWorld::put(node, assemble("sethalterr\nldc 0\nldc 0\nseterr\nldc 0\nstopp", from_start(0x200)));
    world.boot(host, from_start(0x200), from_start(0x800));
    node.analyse_at(500us);
    host.will_give(600us, peek_command(from_start(0x30)));
    world.run();
    CHECK_EQ(told, 1);
    CHECK_EQ(host.received(), word_bytes(from_start(0x206))); // after seterr
}
