#pragma once

#include "netlist/network/direction.hpp"
#include "netlist/network/value.hpp"
#include "text/source.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::transputer {
class CodeLines; // runtime/transputer/code_lines.hpp
} // namespace placedpar::transputer

namespace placedpar {

struct DeviceKind; // netlist/kinds/device_kind.hpp: what a device of some kind is and can do
namespace transputer {
struct Image; // runtime/transputer/image.hpp
} // namespace transputer
namespace iserver {
class OfferedBoard; // iserver/offered_board.hpp
class Terminal;     // iserver/terminal.hpp
struct Answer;      // iserver/server.hpp
} // namespace iserver

/// These structures describe an elaborated netlist: every array unrolled, every name resolved, every channel placed.
/// Indices are positions in the vectors of Network. Names are unique within their vector.

inline constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

/// Describes a node of the network: a device of some kind, or an edge. Wires connect nodes.
struct Node {
    std::string name; ///< such as "t[0][1]"
    std::string type; ///< such as "T800", "C004" or "edge"; "T800" also for a B404, a module with a T800
    std::shared_ptr<const DeviceKind> kind;               ///< never null in a Network
    std::map<std::string, Value, std::less<>> attributes; ///< every attribute of the kind
    bool overlapped_acknowledge = true;            ///< its links send the acknowledge of a byte while the byte arrives
    bool floating_point_unit = true;               ///< the processor has a floating-point unit, as a T800 has
    std::set<std::string, std::less<>> given = {}; ///< names of the attributes that the netlist gives
    std::map<std::string, Value> other;            ///< attributes that only icconf uses; no effect on a simulation
    Location declared;
    std::string boot_file = ""; ///< path of the bootable file that a host sends to the node; "" if none
    std::shared_ptr<const std::vector<std::uint8_t>> boot_bytes = nullptr; ///< contents of this file
    Location boot_stated = {};                                             ///< place of the `use` that names the file
    std::shared_ptr<const transputer::CodeLines> code_lines =
        nullptr;                ///< contents of NAME.lines beside the file; null if there is none
    bool runs_own_code = false; ///< the node is emulated: it executes the bytes that boot it, or its image
    /// Holds the program that is in the node's memory when the run begins. It contains all processes in occam on the
    /// node, and processes that pass on messages between such processes. Null if the node needs no such program.
    std::shared_ptr<const transputer::Image> image = nullptr;
    std::optional<std::size_t> rank = {}; ///< thread or MPI rank of its processes in a native run; empty: not stated

    /// REQUIRES: the kind has an integer attribute of this name; throws std::logic_error otherwise.
    std::int64_t integer(std::string_view attribute) const;
};

struct LinkEnd {
    std::size_t node = nowhere;
    int link = -1; ///< -1 at an edge

    bool at_edge() const { return link < 0; }
    bool operator==(const LinkEnd&) const = default;
};

/// Describes the passage of a connection through a crossbar switch, in the direction from end a to end b.
struct SwitchCrossing {
    std::size_t node = nowhere;
    int from_link = 0, to_link = 0;
};

/// In LinkEnd::link, this number stands for the connector by which a device is attached to a bus. A way over a bus
/// (BusWay) begins at such a connector.
inline constexpr int bus_port = std::numeric_limits<int>::max();
/// In LinkEnd::link, this number stands for the link `config`, by which a switch is set during the run.
inline constexpr int configuration_link = bus_port - 1;

/// Describes a device in a slot of a bus.
struct BusAttachment {
    std::size_t node = nowhere, bus = nowhere;
    int slot = 1;
    int level = 3;           ///< level of a master's requests, BR0 to BR3
    bool on_request = false; ///< true: a master releases the bus when another master requests it; false: after each
                             ///< block of words
    std::string name;        ///< name of the `connection` that attaches the device; "" if none
    Location connected;
};

/// Describes a way over a bus: the path of messages from a master to a slave, and then over a wire if the slave is a
/// link adapter.
struct BusWay {
    std::size_t master = nowhere, slave = nowhere; ///< indices in Network::attachments
    std::size_t wire = nowhere; ///< connection at the link adapter; nowhere: the way ends in a bus master's memory
};

/// Describes a wire between two links, with the switches that it passes, or a way over a bus. At most one end is at an
/// edge.
struct LinkConnection {
    LinkEnd a, b;
    std::int64_t bits_per_second = 20'000'000;
    double metres = 0;                     ///< total length of the wires between links and switches
    std::vector<SwitchCrossing> crossings; ///< in order from a to b
    std::string name;                      ///< name of the `connection` that wires the links; "" if none
    Location connected;
    std::optional<BusWay> over_bus = {}; ///< if set, the connection is not a wire: `a` is a master, `b` the device that
                                         ///< the master reaches over the bus
    bool at_run_time = false; ///< a program makes the connection during the run, by setting switches; several such
                              ///< connections may have the same links
    /// Names by which the option --set changes its speed: the names of its wires that state a speed, or of its first
    /// wire if none does. Wires without a name are "wire[0]", "wire[1]" ... in the order of the netlist.
    std::vector<std::string> names_for_set = {};

    int switches() const { return static_cast<int>(crossings.size()); }
};

/// Describes a wire that becomes part of a connection during the run, when a program sets switches. Several such
/// connections may share the wire.
struct WirePiece {
    LinkEnd a, b;                                ///< at least one end is at a switch
    std::string name;                            ///< name of its `connection`; "" if none
    std::optional<std::int64_t> bits_per_second; ///< speed, if its `connection` states one
    double metres = 0;

    bool operator==(const WirePiece&) const = default;
};

/// Holds one entry of a declared `interface (...)`.
struct DeclaredEntry {
    std::string type; ///< "input" or "output" for a channel end; "int", "char", "double" ... for a parameter
    std::string name;
    std::vector<std::int64_t> dimensions; ///< empty: a single channel end or parameter

    bool operator==(const DeclaredEntry&) const = default;
};

/// Describes a connected port of a process. Optional ports that are not connected are not listed.
struct PortBinding {
    std::string port; ///< such as "to_slaves" or "out[2]"; the kind's port is "to_slaves" or "out"
    Direction direction;
    std::size_t channel = nowhere;
};

struct ProcessInstance {
    std::string name;               ///< such as "grid[1][2]"
    std::string kind;               ///< the kind that `use` names; "" if there is no `use`
    bool stand_in = false;          ///< the kind is not in the catalogue: the process cannot be run
    bool is_code = false;           ///< the process is in occam, so it is part of the image of its node
    std::uint64_t program_hash = 0; ///< hash of the program's source files, if the kind is made from source files; 0
                                    ///< for other kinds
    std::map<std::string, Value> parameters; ///< every parameter of the kind, of the type that the kind states
    std::map<std::string, Location>
        given; ///< place where the netlist gives each parameter; parameters with default values are not listed
    std::vector<std::string> given_in_order; ///< parameters that the netlist gives; an array is listed by its base name
    /// Holds the declared entries in the order of the netlist, since a program may fetch parameters by position. Null
    /// if the netlist declares no interface.
    std::shared_ptr<const std::vector<DeclaredEntry>> interface;
    bool high_priority = false;
    std::size_t node = nowhere;
    std::vector<PortBinding> ports; ///< in the order of the kind's ports; for a stand-in, in the order of the interface
    std::map<std::string, Value> other; ///< attributes that only icconf uses; no effect on a simulation
    Location declared;
};

/// Describes the end of a channel: at a port of a process, at an edge channel, or in the program of a node that
/// executes its own code. Without a process, `process` is nowhere, and `port` is the name of the edge channel, or "".
struct ChannelEnd {
    std::size_t process = nowhere;
    std::string port;
    std::size_t node = nowhere; ///< node on which the process is placed, the edge, or the node with the program

    bool at_edge() const { return process == nowhere; }
};

/// Describes the passage of a channel over one wire.
struct RouteHop {
    std::size_t connection = nowhere;
    bool from_a_to_b = true;

    bool operator==(const RouteHop&) const = default;
};

/// Describes what carries a channel.
struct ChannelPlacement {
    enum class Kind { soft, link, edge };
    Kind kind = Kind::soft;
    std::vector<RouteHop> route = {}; ///< empty for a soft channel; several hops pass through the processors in between
    bool in_packets =
        false; ///< the route has several hops, or one of its links carries another channel in the same direction
    /// Holds the index of the bus on which the channel is broadcast: one write reaches the adapters of all channels of
    /// the broadcast. nowhere: the channel is not broadcast.
    std::size_t broadcast_on = nowhere;

    bool operator==(const ChannelPlacement&) const = default;
};

struct NetworkChannel {
    std::string name;    ///< name of the `connection` by which it was connected, or "a.out -> b.in"
    ChannelEnd from, to; ///< at most one end has no process
    ChannelPlacement placement;
    Location connected;

    /// Returns the end at a node that runs its own code, which sends or receives the messages; null if the channel
    /// leads from a process to a process, or to an edge.
    const ChannelEnd* end_at_code() const {
        const bool leads_to_code = placement.kind == ChannelPlacement::Kind::link && (from.at_edge() || to.at_edge());
        return !leads_to_code ? nullptr : from.at_edge() ? &from : &to;
    }
};

/// Returns whether the two channels belong to the same port array and the same bus, so that each message goes to the
/// adapters of both channels. REQUIRES: both channels are broadcast.
bool are_one_broadcast(const NetworkChannel&, const NetworkChannel&);

/// Describes a fault of a link or a device in a run.
struct Fault {
    std::string kind;                                     ///< "silent", "halts"
    std::size_t node = nowhere;                           ///< the failing device, or the device with the failing link
    int link = -1;                                        ///< number of the link; -1: the device itself fails
    std::size_t connection = nowhere;                     ///< the wire at the failing link
    std::map<std::string, Value, std::less<>> attributes; ///< all attributes of the kind
    Location stated;

    /// REQUIRES, for both functions: the fault's kind has an attribute of this name and type.
    std::int64_t integer(std::string_view attribute) const {
        return std::get<std::int64_t>(attributes.find(attribute)->second);
    }
    const std::string& text(std::string_view attribute) const {
        return std::get<std::string>(attributes.find(attribute)->second);
    }
};

/// Describes a value that an option set in place of the netlist's value.
struct SetByOption {
    std::string name, value;           ///< as typed by the user
    std::vector<std::string> elements; ///< elements whose attribute or parameter was set; empty: the option set a
                                       ///< constant (`val`)
};

/// Describes the services that the hosts of booted nodes offer to their programs.
struct HostServices {
    std::string folder = "";       ///< the only folder whose files a program can reach; "": none
    std::string command_line = ""; ///< arguments of the program
    std::map<std::string, std::string> environment = {};
    std::uint64_t write_limit_bytes = 64U << 20;
    bool lists_code = false; ///< counts the instructions that booted nodes execute
    bool analyses = false;   ///< shows the state of booted nodes at the end
    std::istream* steps =
        nullptr; ///< commands to a stepper, which executes the code of the booted node in steps; null: there is none
    /// Makes the terminal of a host. If the function is empty, the screen shows nothing, and no key is pressed.
    std::function<std::shared_ptr<iserver::Terminal>()> terminal = {};
    /// Answers a request at the given virtual time, in place of a server. If the function is empty, a server answers.
    std::function<iserver::Answer(std::span<const std::uint8_t>, std::chrono::microseconds)> answers = {};
    iserver::OfferedBoard* board =
        nullptr; ///< link over which another program boots and serves the machine; null: hosts are simulated
};

struct Network {
    std::vector<Node> nodes;
    std::vector<LinkConnection> connections; ///< the wires, then the ways over buses
    std::vector<WirePiece> pieces;           ///< wires that switches join during the run
    std::vector<BusAttachment> attachments;
    std::vector<ProcessInstance> processes;
    std::vector<NetworkChannel> channels;
    std::vector<Fault> faults;
    std::string source_path;
    std::vector<std::string> included_paths; ///< paths of the included files
    bool includes_toolset = false; ///< the netlist includes a file of the toolset, or uses its predefined names
    std::vector<SetByOption> set;
    HostServices host;      ///< set by the program that runs the network, not by the netlist
    std::uint64_t hash = 0; ///< FNV-1a of its canonical form (netlist/print/print.hpp)

    /// Returns the number of connections that are wires.
    std::size_t count_wires() const;
};

/// Returns the paths of all files that the netlist names: included files, then bootable files.
std::vector<std::string> paths_of_inputs(const Network& network);

/// Returns whether some node is booted with a file, or has an image.
bool has_bootable_file(const Network& network);

/// Returns the network as a machine executes it. The processes in occam (ProcessInstance::is_code) are then part of the
/// programs in their nodes' memory. They are no longer listed, nor are the channels between them; their other channels
/// end at the nodes.
Network with_code_inside(Network network);

/// Returns whether both ends of a channel are processes in occam (ProcessInstance::is_code).
bool is_between_code(const Network& network, const NetworkChannel& channel);

/// Returns whether a wire leads to the switch's configuration link.
bool is_set_at_run_time(const Network& network, std::size_t node);

bool is_on_bus(const Network& network, std::size_t node);

/// Returns "t[0].link[2]", "sun.bus[0]", or the name of an edge.
std::string link_name(const std::vector<Node>& nodes, const LinkEnd& end);

/// These two functions return where a hop begins and where it ends.
inline const LinkEnd& begin_of(const RouteHop& hop, const std::vector<LinkConnection>& connections) {
    return hop.from_a_to_b ? connections[hop.connection].a : connections[hop.connection].b;
}
inline const LinkEnd& end_of(const RouteHop& hop, const std::vector<LinkConnection>& connections) {
    return hop.from_a_to_b ? connections[hop.connection].b : connections[hop.connection].a;
}

} // namespace placedpar
