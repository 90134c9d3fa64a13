#pragma once

#include "runtime/event.hpp"
#include "runtime/hardware/link.hpp"
#include "runtime/kernel.hpp"
#include "runtime/simulation.hpp"
#include "runtime/transputer/assembler.hpp"
#include "runtime/transputer/byte_lane.hpp"
#include "runtime/transputer/node.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::test {

/// Returns the address of the byte at this offset from the beginning of a transputer's memory.
constexpr std::uint32_t from_start(std::uint32_t offset) { return transputer::most_negative + offset; }

/// The far end of a link. It gives bytes at set times, and takes each byte that arrives.
class ScriptedEnd final : public transputer::ByteEnd, private Event {
public:
    explicit ScriptedEnd(Kernel& kernel) : kernel_(kernel) {}
    /// Gives these bytes at the time `at`, or later, when all earlier bytes have been acknowledged.
    void will_give(Time at, std::vector<std::uint8_t> bytes);

    const std::vector<std::uint8_t>& received() const { return received_; }
    const std::vector<Time>& received_at() const { return received_at_; }
    /// Returns the times at which bytes were acknowledged, one for each will_give().
    const std::vector<Time>& given_at() const { return given_at_; }

private:
    struct Gift {
        Time at;
        std::vector<std::uint8_t> bytes;
    };
    void happen() noexcept override;
    void begin_next();
    void read(std::span<std::uint8_t>) override;
    void given() override;
    void write(std::span<const std::uint8_t>) override;
    void taken() override;
    void byte_waits() override { in->take(1); }

    Kernel& kernel_;
    std::vector<Gift> gifts_;
    std::size_t next_ = 0, read_ = 0;
    bool gives_ = false;
    std::vector<std::uint8_t> received_;
    std::vector<Time> received_at_, given_at_;
};

/// Emulated transputers and their links. Code is put into the memories before the run. A host at link 0 of each node
/// then boots the node by a few bytes, which jump to the code.
class NodeWorld {
public:
    struct Options {
        transputer::Model model = transputer::Model::t800;
        std::uint64_t memory = 8192;
        transputer::CoreTiming timing = {};
    };
    transputer::Node& node(const std::string& name, const Options&);
    hardware::Link& connect(transputer::ByteEnd& a, transputer::ByteEnd& b, const hardware::LinkTiming& = {});
    /// Connects links of two nodes.
    hardware::Link& connect(transputer::Node& a, int link_of_a, transputer::Node& b, int link_of_b,
                            const hardware::LinkTiming& = {});
    /// Connects a host with a node.
    ScriptedEnd& host(transputer::Node&, int link = 0, const hardware::LinkTiming& = {});

    /// Puts a program into the memory.
    static void put(transputer::Node&, const transputer::Assembly&);
    /// Lets the host boot the node at this time. The node then jumps to the code, at low priority.
    void boot(ScriptedEnd& host, std::uint32_t code, std::uint32_t workspace, Time at = Time{0});
    /// Puts a program into the memory, at `origin`, and boots a node with a host of its own.
    void run_at_boot(transputer::Node&, std::string_view source, std::uint32_t workspace = from_start(0x800),
                     std::uint32_t origin = from_start(0x200));

    /// Runs until nothing more can happen. Returns the time of the end.
    Time run(Time limit = Time::max());

    Simulation simulation;
};

/// Notes when the instructions at some addresses began for the first time.
struct InstructionTimes final : transputer::Core::Watcher {
    explicit InstructionTimes(transputer::Core& c) : core(c) { core.watch(this); }
    InstructionTimes(const InstructionTimes&) = delete;
    void begins(transputer::Word at) override {
        if (const auto found = times.find(at); found != times.end() && !found->second)
            found->second = core.local_time();
    }
    void executed(transputer::Word, transputer::HalfCycles) override {}

    transputer::Core& core;
    std::map<transputer::Word, std::optional<Time>> times;
};

/// Returns the word at this offset from the beginning of the memory.
inline std::uint32_t word_at(transputer::Node& node, std::uint32_t offset) { return node.core().memory().word(offset); }

} // namespace placedpar::test
