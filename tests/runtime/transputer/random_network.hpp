#pragma once

#include "node_world.hpp"

#include "runtime/hardware/link.hpp"
#include "runtime/time.hpp"
#include "runtime/trace.hpp"
#include "runtime/transputer/core.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace placedpar::test {

/// A network of emulated transputers with programs, determined by a seed. The programs compute, communicate by soft
/// channels and links, alternate, and wait for clocks, at both priorities. They read clocks often and store values that
/// depend on the readings, so that a difference in time leads to a difference in memory. They never read memory that a
/// link is about to write, nor write memory that a link reads. In some networks links have faults, and a transputer
/// halts or is analysed.
struct RandomNetwork {
    struct Booted {
        NodeWorld::Options options;
        std::string source;
        std::uint32_t origin;
        std::uint32_t workspace;
        Time boot_at;
        std::vector<std::uint8_t> from_host; ///< bytes that the host sends after the boot, at `from_host_at`
        Time from_host_at;
        std::optional<Time> halt_at = std::nullopt, analyse_at = std::nullopt;
    };
    struct Wire {
        std::size_t a, b;
        int link_of_a, link_of_b;
        hardware::LinkTiming timing;
        std::vector<hardware::LinkFault> faults = {};
    };
    std::vector<Booted> nodes;
    std::vector<Wire> wires;
};

/// The length of the programs grows with `scale`.
RandomNetwork random_network(std::uint64_t seed, unsigned scale = 1);

/// The way in which a network is run. Only `until` may affect the outcome.
struct WayToRun {
    std::uint64_t order = 0; ///< determines the order in which nodes, links and hosts are made; 0: the usual order
    bool instruction_by_instruction = false;
    bool every_byte = false; ///< LinkDirection::simulate_every_byte
    TraceSink* trace = nullptr;
    std::function<void(transputer::Node&)> at_end = [](transputer::Node&) {};
    std::optional<Time> ahead_by = std::nullopt; ///< Node::run_ahead_by
    Time until = std::chrono::seconds{1};
};

/// The state of a node after a run.
struct NodeOutcome {
    transputer::Registers registers;
    std::vector<std::uint8_t> memory, host_received;
    std::vector<Time> host_received_at;
    std::uint64_t instructions;
    transputer::HalfCycles busy;
    Time local_time, time_busy, taken_by_links;
};

std::vector<NodeOutcome> run_network(const RandomNetwork&, const WayToRun&);

/// Describes the first difference between two outcomes; "" if there is none.
std::string difference_of(const std::vector<NodeOutcome>&, const std::vector<NodeOutcome>&);

} // namespace placedpar::test
