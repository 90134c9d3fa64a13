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

/// These structures describe a netlist after all its statements have been executed and checked. Each element of an
/// array is listed, names are replaced by indices, and each channel is placed in memory or on a link. The simulator,
/// the drawings and the reports use this form. Indices are positions in the vectors of Network. Names are unique within
/// their vector.

inline constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

/// Describes a node of the network: a device, or an edge, where the network ends and the outside world begins. Wires
/// connect nodes.
struct Node {
    std::string name; ///< such as "t[0][1]"
    std::string type; ///< such as "T800", "C004" or "edge"; a B404, which is a module with a T800, has the type "T800"
    std::shared_ptr<const DeviceKind> kind;               ///< never null in a Network
    std::map<std::string, Value, std::less<>> attributes; ///< every attribute of the kind
    bool overlapped_acknowledge = true;                   ///< its links acknowledge a byte while the byte arrives
    bool floating_point_unit = true;                      ///< the processor has a floating-point unit, as a T800 has
    std::set<std::string, std::less<>> given = {};        ///< names of the attributes that the netlist gives
    std::map<std::string, Value>
        other; ///< attributes that only INMOS's configurer icconf uses; no effect on a simulation
    Location declared;
    std::string boot_file = ""; ///< path of the bootable file that a host sends to the node; "" if none
    std::shared_ptr<const std::vector<std::uint8_t>> boot_bytes = nullptr; ///< contents of this file
    Location boot_stated = {};                                             ///< place of the `use` that names the file
    std::shared_ptr<const transputer::CodeLines> code_lines =
        nullptr; ///< source line of each instruction in the file, read from NAME.lines beside it; null if there is none
    bool runs_own_code =
        false; ///< the node is an emulated transputer: it executes the instructions of its bootable file or image
    /// Holds the program that is in the node's memory when the run begins. The program contains all processes in occam
    /// on the node. It also contains processes that pass on messages, if channels between processes in occam share a
    /// wire or lead through the node. Null if the node needs no such program.
    std::shared_ptr<const transputer::Image> image = nullptr;
    std::optional<std::size_t> rank = {}; ///< thread or MPI rank of its processes in a native run; empty: not stated

    /// Throws std::logic_error if the kind has no integer attribute of this name.
    std::int64_t integer(std::string_view attribute) const;
};

struct LinkEnd {
    std::size_t node = nowhere;
    int link = -1; ///< -1 at an edge

    bool at_edge() const { return link < 0; }
    bool operator==(const LinkEnd&) const = default;
};

/// Describes the passage of a connection through a crossbar switch. `from_link` is the link towards end a of the
/// connection, `to_link` the link towards end b.
struct SwitchCrossing {
    std::size_t node = nowhere;
    int from_link = 0, to_link = 0;
};

/// In LinkEnd::link, this number stands for the connector by which a device is attached to a bus.
inline constexpr int bus_port = std::numeric_limits<int>::max();
/// In LinkEnd::link, this number stands for the link `config`, by which a switch is set during the run.
inline constexpr int configuration_link = bus_port - 1;

/// Describes a device in a slot of a bus.
struct BusAttachment {
    std::size_t node = nowhere, bus = nowhere;
    int slot = 1;
    int level = 3;           ///< level of a master's requests, BR0 to BR3
    bool on_request = false; ///< true: the master releases the bus when another master requests the bus; false: after
                             ///< each block of words
    std::string name;        ///< name of the `connection` that attaches the device; "" if none
    Location connected;
};

/// Describes a way over a bus: the path of messages from a master of the bus to a slave. If the slave is a link
/// adapter, the path continues over the wire at the adapter.
struct BusWay {
    std::size_t master = nowhere, slave = nowhere; ///< indices in Network::attachments
    std::size_t wire =
        nowhere; ///< index of the connection at the link adapter; nowhere: the way ends in a bus master's memory
};

/// Describes a connection of two nodes: a wire between two links, with the switches that the wire passes, or a way over
/// a bus. At most one end is at an edge.
struct LinkConnection {
    LinkEnd a, b;
    std::int64_t bits_per_second = 20'000'000;
    double metres = 0;                     ///< total length of the wires between links and switches
    std::vector<SwitchCrossing> crossings; ///< in order from a to b
    std::string name;                      ///< name of the `connection` in the netlist that joins the links; "" if none
    Location connected;
    std::optional<BusWay> over_bus =
        {}; ///< set for a way over a bus: `a` is then the master, `b` the device that the master reaches
    bool at_run_time = false; ///< the connection exists only while a program sets switches to make it; several such
                              ///< connections may share a link
    /// Names by which the option --set changes its speed: the names of its wires that state a speed, or of its first
    /// wire if none does. Wires without a name are "wire[0]", "wire[1]" ... in the order of the netlist.
    std::vector<std::string> names_for_set = {};

    int switches() const { return static_cast<int>(crossings.size()); }
};

/// Describes a wire that ends at a switch. The wire becomes part of a connection when a program sets the switch during
/// the run. Several such connections may share the wire.
struct WirePiece {
    LinkEnd a, b;                                ///< at least one end is at a switch
    std::string name;                            ///< name of its `connection`; "" if none
    std::optional<std::int64_t> bits_per_second; ///< speed of the wire; empty if the netlist states none
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

/// Describes a connected port, that is, a channel end in the interface of a process. Ports that are not connected are
/// not listed.
struct PortBinding {
    std::string port; ///< such as "to_slaves", or "out[2]" for an element of the port array "out"
    Direction direction;
    std::size_t channel = nowhere;
};

struct ProcessInstance {
    std::string name;      ///< such as "grid[1][2]"
    std::string kind;      ///< the kind that `use` names; "" if there is no `use`
    bool stand_in = false; ///< the kind is not in the catalogue of kinds: the process can be drawn, but not run
    bool is_code = false;  ///< the process is in occam, so the image of its node contains it
    std::uint64_t program_hash = 0; ///< hash of the program's source files, if the kind is made from source files; 0
                                    ///< for other kinds
    std::map<std::string, Value> parameters; ///< all parameters, including those that have their default values
    std::map<std::string, Location> given;   ///< place where the netlist gives each parameter; parameters that the
                                             ///< netlist does not give are not listed
    std::vector<std::string> given_in_order; ///< parameters that the netlist gives; an array is listed by its base name
    /// Holds the entries of the declared interface in the order of the netlist, since a C program may fetch its
    /// parameters by position. Null if the netlist declares no interface.
    std::shared_ptr<const std::vector<DeclaredEntry>> interface;
    bool high_priority = false;
    std::size_t node = nowhere;
    std::vector<PortBinding> ports; ///< in the order of the kind's ports; for a stand-in, in the order of the interface
    std::map<std::string, Value>
        other; ///< attributes that only INMOS's configurer icconf uses; no effect on a simulation
    Location declared;
};

/// Describes the end of a channel: at a port of a process, at an edge, or in the machine code of an emulated
/// transputer. If the end is not at a process, `process` is nowhere, and `port` is the name of the edge's channel, or
/// "".
struct ChannelEnd {
    std::size_t process = nowhere;
    std::string port;
    std::size_t node = nowhere; ///< node of the process, the edge, or the emulated transputer

    bool at_edge() const { return process == nowhere; }
};

/// Describes the passage of a channel over one wire or one way over a bus.
struct RouteHop {
    std::size_t connection = nowhere;
    bool from_a_to_b = true;

    bool operator==(const RouteHop&) const = default;
};

/// Describes what carries a channel: the memory of one processor (soft), a route over links and buses, or a link to an
/// edge.
struct ChannelPlacement {
    enum class Kind { soft, link, edge };
    Kind kind = Kind::soft;
    std::vector<RouteHop> route =
        {};                  ///< empty for a soft channel; between two hops, a processor passes the messages on
    bool in_packets = false; ///< messages are sent in packets, because the route has several hops, or shares a link
                             ///< with another channel in the same direction
    /// Holds the index of the bus on which the channel is broadcast. One write on this bus reaches the link adapters of
    /// all channels of the broadcast. nowhere: the channel is not broadcast.
    std::size_t broadcast_on = nowhere;

    bool operator==(const ChannelPlacement&) const = default;
};

struct NetworkChannel {
    std::string name;    ///< name of the `connection` in the netlist, or "a.out -> b.in"
    ChannelEnd from, to; ///< at most one end has no process
    ChannelPlacement placement;
    Location connected;

    /// Returns the end at an emulated transputer, whose machine code sends or receives the messages. Returns null if
    /// the channel has no such end.
    const ChannelEnd* end_at_code() const {
        const bool leads_to_code = placement.kind == ChannelPlacement::Kind::link && (from.at_edge() || to.at_edge());
        return !leads_to_code ? nullptr : from.at_edge() ? &from : &to;
    }
};

/// Returns whether both channels belong to one port array and are placed on one bus, so that each message reaches both
/// receivers. REQUIRES: both channels are broadcast.
bool are_one_broadcast(const NetworkChannel&, const NetworkChannel&);

/// Describes a fault of a link or a device in a run.
struct Fault {
    std::string kind;                                     ///< "silent", "halts"
    std::size_t node = nowhere;                           ///< the failing device, or the device with the failing link
    int link = -1;                                        ///< number of the link; -1: the device itself fails
    std::size_t connection = nowhere;                     ///< index of the wire at the failing link
    std::map<std::string, Value, std::less<>> attributes; ///< all attributes of the kind
    Location stated;

    /// Return the value of an attribute. REQUIRES: the fault's kind has an attribute of this name and type.
    std::int64_t integer(std::string_view attribute) const {
        return std::get<std::int64_t>(attributes.find(attribute)->second);
    }
    const std::string& text(std::string_view attribute) const {
        return std::get<std::string>(attributes.find(attribute)->second);
    }
};

/// Describes a value that the option `--set` has given in place of the netlist's value.
struct SetByOption {
    std::string name, value;           ///< as typed by the user
    std::vector<std::string> elements; ///< names of the processes, nodes and connections in which the value was set;
                                       ///< empty: the option set a constant (`val`)
};

/// Describes what the host of a booted transputer offers to the transputer's program: files, arguments, a terminal.
struct HostServices {
    std::string folder = "";       ///< the only folder whose files a program can reach; "": none
    std::string command_line = ""; ///< arguments of the program
    std::map<std::string, std::string> environment = {};
    std::uint64_t write_limit_bytes = 64U << 20;
    bool lists_code = false;       ///< whether the executed instructions are counted
    bool analyses = false;         ///< whether the state of booted nodes is shown at the end
    std::istream* steps = nullptr; ///< commands of a debugger, which executes the booted node's code step by step;
                                   ///< null: no debugger is used
    /// Makes the terminal of a host. If the function is empty, the program's output is not shown, and no key is
    /// pressed.
    std::function<std::shared_ptr<iserver::Terminal>()> terminal = {};
    /// Answers a program's request at the given virtual time. If the function is empty, PlacedPar's own server answers.
    std::function<iserver::Answer(std::span<const std::uint8_t>, std::chrono::microseconds)> answers = {};
    iserver::OfferedBoard* board =
        nullptr; ///< connection over which another program acts as the host; null: PlacedPar is the host
};

struct Network {
    std::vector<Node> nodes;
    std::vector<LinkConnection> connections; ///< first the wires, then the ways over buses
    std::vector<WirePiece> pieces;           ///< wires that switches join during the run
    std::vector<BusAttachment> attachments;
    std::vector<ProcessInstance> processes;
    std::vector<NetworkChannel> channels;
    std::vector<Fault> faults;
    std::string source_path;
    std::vector<std::string> included_paths; ///< paths of the included files
    bool includes_toolset =
        false; ///< the netlist includes a file of INMOS's toolset, or uses the names that such a file declares
    std::vector<SetByOption> set;
    HostServices host;      ///< set by the command that runs the network, not by the netlist
    std::uint64_t hash = 0; ///< FNV-1a hash of canonical_form() (netlist/print/print.hpp)

    /// Returns the number of connections that are wires.
    std::size_t count_wires() const;
};

/// Returns the paths of all files that the netlist names: included files, then bootable files.
std::vector<std::string> paths_of_inputs(const Network& network);

/// Returns whether some node executes machine code: a bootable file, or an image.
bool has_bootable_file(const Network& network);

/// Returns the network as a Machine simulates it. Processes in occam are then removed, because the images of their
/// nodes contain them. Channels between two processes in occam are removed, too. A channel between a process in occam
/// and a process in C++ then ends at the node of the process in occam.
Network with_code_inside(Network network);

/// Returns whether both ends of a channel are at processes in occam (ProcessInstance::is_code).
bool is_between_code(const Network& network, const NetworkChannel& channel);

/// Returns whether a program can set the switch during the run: whether a wire leads to its configuration link.
bool is_set_at_run_time(const Network& network, std::size_t node);

bool is_on_bus(const Network& network, std::size_t node);

/// Returns "t[0].link[2]", "sun.bus[0]", or the name of an edge.
std::string link_name(const std::vector<Node>& nodes, const LinkEnd& end);

/// These two functions return the link at which a hop begins, and the link at which it ends.
inline const LinkEnd& begin_of(const RouteHop& hop, const std::vector<LinkConnection>& connections) {
    return hop.from_a_to_b ? connections[hop.connection].a : connections[hop.connection].b;
}
inline const LinkEnd& end_of(const RouteHop& hop, const std::vector<LinkConnection>& connections) {
    return hop.from_a_to_b ? connections[hop.connection].b : connections[hop.connection].a;
}

} // namespace placedpar
