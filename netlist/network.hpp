#pragma once

#include "netlist/catalogue.hpp"
#include "netlist/value.hpp"
#include "text/source.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

/// What a netlist comes to: every array unrolled, every name resolved, every channel placed. Indices are
/// positions in the vectors of Network. Names are unique within their vector.

inline constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

enum class NodeKind {
    processor,
    workstation, ///< a host computer: any number of links, processes on it run in no time
    edge,        ///< where the network ends
    c004         ///< a crossbar switch; connections through it are resolved to the processors at their ends
};

struct Node {
    std::string name; ///< such as "t[0][1]"
    std::string type; ///< the processor's base type, such as "T800" for a B404; "edge", ...
    NodeKind kind = NodeKind::processor;
    std::int64_t memory_bytes = 0;
    std::int64_t clock_hz = 20'000'000;
    std::int64_t link_bits_per_second = 20'000'000;
    bool overlapped_acknowledge = true;   ///< its links acknowledge a byte while it comes in
    std::int64_t channel_call_cycles = 0; ///< what the communication library charges per channel operation
    std::map<std::string, Value> other;   ///< attributes of the real tool that a simulation has no use for
    Location declared;
};

struct LinkEnd {
    std::size_t node = nowhere;
    int link = -1; ///< -1 at an edge
};

/// A way through a crossbar switch, from a's side to b's.
struct SwitchCrossing {
    std::size_t node = nowhere;
    int from_link = 0, to_link = 0;
};

/// A wire from link to link, with the switches on its way. Never from edge to edge.
struct LinkConnection {
    LinkEnd a, b;
    std::int64_t bits_per_second = 20'000'000;
    double metres = 0;                     ///< of wire, all pieces together
    std::vector<SwitchCrossing> crossings; ///< in order from a to b
    std::string name;                      ///< of the `connection` it was wired by; "" if none
    Location connected;

    int switches() const { return static_cast<int>(crossings.size()); }
};

/// A connected port of a process. Ports that are optional and not connected are not listed.
struct PortBinding {
    std::string port; ///< such as "to_slaves" or "out[2]"; the kind knows it by its base name, "out"
    Direction direction;
    std::size_t channel = nowhere;
};

struct ProcessInstance {
    std::string name;                        ///< such as "grid[1][2]"
    std::string kind;                        ///< from `use`; "" if nothing was said
    bool stand_in = false;                   ///< the kind is no kind of the catalogue: it cannot be run
    std::map<std::string, Value> parameters; ///< every parameter of the kind, of the type the kind states
    std::map<std::string, Location> given; ///< where the netlist gives a parameter; without those left to their default
    bool high_priority = false;
    std::size_t node = nowhere;
    std::vector<PortBinding> ports;     ///< in the order of the kind's ports; of the interface for a stand-in
    std::map<std::string, Value> other; ///< attributes of the real tool that a simulation has no use for
    Location declared;
};

/// A process's port, or an edge channel: then `process` is nowhere and `port` the edge channel's name.
struct ChannelEnd {
    std::size_t process = nowhere;
    std::string port;
    std::size_t node = nowhere; ///< that holds the process; the edge

    bool at_edge() const { return process == nowhere; }
};

/// What carries a channel.
struct ChannelPlacement {
    enum class Kind { soft, link, edge };
    Kind kind = Kind::soft;
    std::size_t connection = nowhere; ///< for link and edge
    bool from_a_to_b = true;
    bool shared = false; ///< more than one channel runs this way over this link

    bool operator==(const ChannelPlacement&) const = default;
};

struct NetworkChannel {
    std::string name;    ///< of the `connection` it was connected by, or "a.out -> b.in"
    ChannelEnd from, to; ///< at most one of them is at an edge
    ChannelPlacement placement;
    Location connected;
};

struct Network {
    std::vector<Node> nodes;
    std::vector<LinkConnection> connections;
    std::vector<ProcessInstance> processes;
    std::vector<NetworkChannel> channels;
    std::string source_path;
    std::vector<std::string> included_paths; ///< of the files that it includes
    std::uint64_t hash = 0;                  ///< FNV-1a of the canonical form that print_cfs prints
};

/// "out" for "out[2]"; the name itself without a subscript.
std::string_view base_name(std::string_view name);
/// The subscripts of a name: {2} for "out[2]", {0, 1} for "t[0][1]", empty for "t".
std::vector<std::int64_t> subscripts_of(std::string_view name);

} // namespace placedpar
