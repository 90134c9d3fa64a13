#pragma once

#include "netlist/elaborate/constant.hpp"
#include "netlist/network/network.hpp"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace placedpar {

/// Limits the size of a netlist: the total number of nodes, connections, wires, edge channels, processes, their channel
/// ends and parameters, values given to parameters, and attributes that only icconf uses. Each element of an array
/// counts.
inline constexpr std::size_t most_things = 250'000;

/// The structures below describe a netlist whose statements have been executed, but which has not been checked as a
/// whole. The elaborator fills a Draft; complete() makes a Network of it.

struct DraftConnection {
    std::string name;
    Location declared;
    std::optional<std::int64_t> bits_per_second;
    std::optional<double> metres;
    std::optional<Location> used;             ///< place of the `connect` that uses the connection
    std::map<std::string, Location> settings; ///< attributes set by statements such as `c (length = 0.3);`
    std::optional<int> level = {};            ///< request level of a master on a bus
    std::optional<std::string> release = {};  ///< "RWD", "ROR"
};

struct DraftEdgeChannel {
    std::string name;
    Direction direction;
    Location declared;
    std::optional<Location> connected;
    std::size_t edge = nowhere;
    Location placed;
};

struct PortDeclaration {
    std::string name;
    Direction direction;
    std::vector<std::int64_t> dimensions;
    Location at;
};

struct ParameterDeclaration {
    std::string name, type;
    std::vector<std::int64_t> dimensions;
    std::optional<Constant> default_value;
    Location at;

    bool is_real() const { return type == "float" || type == "double"; }
};

struct Interface {
    std::vector<PortDeclaration> ports;
    std::vector<ParameterDeclaration> parameters;
    std::vector<DeclaredEntry> entries; ///< channels and parameters, in the order of the declaration
};

/// Holds one setting in a statement such as `name (n = 4);`.
struct Setting {
    std::string name;
    Constant value;
    Location at;
};
/// Holds the settings of one statement. All array elements that the statement names share one object.
using SharedSettings = std::shared_ptr<const std::vector<Setting>>;

struct DraftProcess {
    std::string name;
    Location declared;
    bool high_priority = false;
    std::map<std::string, Value> other;
    std::shared_ptr<const Interface> interface; ///< null if the netlist declares no interface
    std::vector<SharedSettings> settings;       ///< one entry for each statement
    std::vector<Setting> overrides;             ///< settings by options, which replace the netlist's settings
    std::string kind;
    std::optional<Location> used; ///< place of the `use` that names the process's program
    std::size_t node = nowhere;
    Location placed;
};

/// Describes a piece of wire, or a crosspoint. Both ends of a crosspoint are at the same switch.
struct DraftWire {
    LinkEnd a, b;
    std::size_t connection = nowhere;
    Location at;
};

/// Holds a statement such as `connect sun.bus[0] to vme.slot[1];`.
struct DraftAttachment {
    std::size_t node = nowhere, bus = nowhere;
    int slot = 1;
    std::size_t connection = nowhere;
    Location at;
};

struct DraftChannelEnd {
    std::size_t process = nowhere;
    std::size_t edge_channel = nowhere; ///< one of `process` and `edge_channel` is set; the other is nowhere
    std::string port;
    Location at;
};

struct DraftChannel {
    DraftChannelEnd a, b;
    std::size_t connection = nowhere;
    Location at;
};

/// Holds a statement such as `place p.out on t.link[2];`. For `... on edge;`, `where.link` is -1. For `... on vme;`,
/// `where.node` is the bus, and `where.link` is `bus_port`.
struct DraftPlacement {
    LinkEnd where;
    Location at;
};

/// Describes a fault of a device, of the wire at a link, or of the wire of a connection. complete_faults() sets the
/// wire.
struct DraftFault {
    Fault fault;
    std::size_t connection = nowhere; ///< index in Draft::connections
    Location at;                      ///< place of the failing thing in the statement
};

/// Holds the statement `place c1 on c2;`.
struct DraftConnectionPlacement {
    std::size_t wire = nowhere; ///< index of `c2`, the connection of a wire
    Location at;
};

struct Draft {
    std::vector<Node> nodes;
    std::vector<int> links; ///< number of links of each node
    /// Holds the places of attributes that follow a declaration, such as `t[1] (rank = 0);`. The key is the node and
    /// the attribute's name.
    std::map<std::pair<std::size_t, std::string>, Location> node_settings;
    std::vector<DraftConnection> connections;
    std::vector<DraftEdgeChannel> edge_channels;
    std::vector<DraftProcess> processes;
    std::vector<DraftWire> wires, crosspoints;
    std::vector<DraftAttachment> attachments;
    std::vector<DraftChannel> channels;
    std::map<std::pair<std::size_t, std::string>, std::vector<DraftPlacement>>
        placements; ///< key: process and port. Several placements, on links of several nodes, state a route.
    std::map<std::size_t, DraftConnectionPlacement>
        connection_placements; ///< key: index of `c1`, the channel's connection
    std::vector<DraftFault> faults;
    std::string default_kind; ///< kind that `use ... for process;` names
    Location default_used;
    std::size_t things = 0;
    std::vector<SetByOption> set;
};

} // namespace placedpar
