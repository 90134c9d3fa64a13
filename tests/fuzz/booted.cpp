// Boots transputers with any bytes.

#include "runtime/hardware/link.hpp"
#include "runtime/simulation.hpp"
#include "runtime/transputer/byte_lane.hpp"
#include "runtime/transputer/core_text.hpp"
#include "runtime/transputer/listing.hpp"
#include "runtime/transputer/node.hpp"
#include "runtime/transputer/stepper.hpp"
#include "runtime/transputer/waiting.hpp"
#include "tests/fuzz/reader.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::fuzz {

namespace {

using namespace std::chrono_literals;

/// The far end of a link: gives bytes from the beginning of the run on, and takes all that come.
class Outside final : public transputer::ByteEnd, private Event {
public:
    explicit Outside(Kernel& kernel) { kernel.future().schedule(*this, Time{0}, EventQueue::timer); }

    std::string bytes;

private:
    void happen() noexcept override {
        taken();
        if (!bytes.empty())
            out->give(static_cast<std::uint32_t>(bytes.size()));
    }
    void read(std::span<std::uint8_t> to) override {
        for (std::uint8_t& each : to)
            each = static_cast<std::uint8_t>(bytes[read_++]);
    }
    void given() override {}
    void write(std::span<const std::uint8_t>) override {}
    void taken() override { in->take(std::numeric_limits<std::uint32_t>::max()); }
    void byte_waits() override {}

    std::size_t read_ = 0;
};

struct Wire {
    Wire(Kernel& kernel, transputer::ByteEnd& a, transputer::ByteEnd& b, const hardware::LinkTiming& timing)
        : link(kernel, timing), lanes(link, a, b) {}
    hardware::Link link;
    transputer::ByteLink lanes;
};

/// The first bytes of an input: what the bytes that follow boot, and how.
struct Machine {
    static constexpr std::size_t bytes = 5;

    explicit Machine(const std::string& text)
        : model(static_cast<transputer::Model>(byte(text, 0) % std::size(transputer::all_traits))),
          memory(2048ULL << (byte(text, 1) % 7)), timing{.clock_hz = byte(text, 1) & 0x80 ? 30'000'000 : 20'000'000,
                                                         .memory_cycles = 2 + static_cast<int>(byte(text, 2) % 8),
                                                         .switch_cycles = byte(text, 2) & 0x80 ? 4 : 0,
                                                         .wraps = (byte(text, 2) & 0x40) == 0},
          how(byte(text, 3)), when(byte(text, 4) * 4us) {}

    static unsigned byte(const std::string& text, std::size_t at) {
        return at < text.size() ? static_cast<std::uint8_t>(text[at]) : 0U;
    }
    bool has(unsigned bit) const { return (how >> bit & 1) != 0; }

    transputer::Model model;
    std::uint64_t memory;
    transputer::CoreTiming timing;
    unsigned how;
    Time when;
};

/// Two transputers with three links to the outside each; their links 3 are joined.
class Pair {
public:
    explicit Pair(const Machine& machine) {
        for (const char* name : {"a", "b"})
            nodes_.push_back(&simulation_.add<transputer::Node>(name, machine.model, machine.memory, machine.timing));
        for (transputer::Node* node : nodes_)
            for (int link = 0; link < 3; ++link) {
                outside_.push_back(&simulation_.add<Outside>());
                connect(*outside_.back(), node->end(link)), node->has_link(wires_.back()->link);
            }
        connect(nodes_[0]->end(3), nodes_[1]->end(3));
        for (transputer::Node* node : nodes_)
            node->has_link(wires_.back()->link);
    }

    transputer::Node& node(std::size_t i) { return *nodes_[i]; }
    /// Deals bytes out to the links: a link, a number of bytes from 1 to 256, the bytes, and so on.
    void deal(std::string_view bytes) {
        while (bytes.size() > 2) {
            const std::size_t end = static_cast<std::uint8_t>(bytes[0]) % outside_.size();
            const std::size_t size = std::size_t{1} + static_cast<std::uint8_t>(bytes[1]);
            outside_[end]->bytes += bytes.substr(2, size);
            bytes.remove_prefix(std::min(bytes.size(), 2 + size));
        }
    }
    void run(Time limit) {
        Channel<int> never("never");
        simulation_.process("waits", [&] { never.in().input(); });
        simulation_.run(limit);
    }
    Simulation& simulation() { return simulation_; }

private:
    void connect(transputer::ByteEnd& a, transputer::ByteEnd& b) {
        wires_.push_back(&simulation_.add<Wire>(a, b, hardware::LinkTiming{}));
    }

    Simulation simulation_;
    std::vector<transputer::Node*> nodes_;
    std::vector<Outside*> outside_;
    std::vector<Wire*> wires_;
};

void require_sense(transputer::Node& node, Time limit) {
    require(node.time_busy() <= limit, "no transputer is busy for longer than the run");
    const bool stopped = node.activity() == transputer::Node::Activity::stopped;
    require(!transputer::print_analysis(node.core(), {}).empty(), "every state can be shown");
    for (const transputer::WaitingProcess& each : transputer::waiting_processes(node.core()))
        transputer::ends_ahead(node.core(), each);
    require(!stopped || !node.core().why_stopped().empty(), "a transputer that stopped says why");
}

} // namespace

void boot_transputers(const std::string& text) {
    const Machine machine(text);
    Pair pair(machine);
    pair.deal(std::string_view(text).substr(std::min(Machine::bytes, text.size())));
    std::istringstream commands("s 5\nr\nw 4\nq\nb #80000070\nm #80000070 8\nl 3\nc\nq\nr\nquit\n");
    std::optional<transputer::Listing> listing;
    const transputer::CodeLines none;
    std::optional<transputer::Stepper> stepper;
    if (machine.has(0))
        listing.emplace(pair.node(0).core());
    else if (machine.has(1))
        stepper.emplace(pair.node(0).core(), none, commands, [](std::string_view) {});
    if (machine.has(2))
        pair.node(1).run_instruction_by_instruction();
    if (machine.has(3))
        pair.node(0).analyse_at(machine.when);
    if (machine.has(4))
        pair.node(1).halt_at(machine.when);
    constexpr Time limit = 3ms;
    pair.run(limit);
    for (std::size_t i = 0; i < 2; ++i)
        require_sense(pair.node(i), limit);
    if (listing)
        print_listing(*listing, {});
}

} // namespace placedpar::fuzz
