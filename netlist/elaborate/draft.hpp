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

/// Limits the size of a netlist. The following are counted together: nodes, connections, wires, channels of edges,
/// processes, their channel ends and parameters, values given to parameters, and attributes that only INMOS's
/// configurer icconf uses. Each element of an array counts separately.
inline constexpr std::size_t most_things = 250'000;

/// The structures below describe a netlist whose statements have been executed, but not yet checked together. The
/// Elaborator fills a Draft, and complete() makes a Network from it. An index refers to a vector of Draft; `nowhere`
/// means none.

struct DraftConnection {
    std::string name;
    Location declared;
    std::optional<std::int64_t> bits_per_second;
    std::optional<double> metres;
    std::optional<Location> used;             ///< place of the `connect` that names the connection
    std::map<std::string, Location> settings; ///< attributes set by statements such as `c (length = 0.3);`
    std::optional<int> level = {};            ///< level at which a master requests its bus, BR0 to BR3
    std::optional<std::string> release =
        {}; ///< when a master releases its bus: "RWD", after each block of words; "ROR", at another master's request
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
    std::vector<DeclaredEntry> entries; ///< ports and parameters together, in the order of the declaration
};

/// Holds the value that a statement such as `name (n = 4);` gives to a parameter or an attribute.
struct Setting {
    std::string name;
    Constant value;
    Location at;
};
/// Holds the settings of one statement. If the statement sets several elements of an array, they share one object.
using SharedSettings = std::shared_ptr<const std::vector<Setting>>;

struct DraftProcess {
    std::string name;
    Location declared;
    bool high_priority = false;
    std::map<std::string, Value> other;
    std::shared_ptr<const Interface> interface; ///< null if the netlist declares no interface
    std::vector<SharedSettings> settings;       ///< one entry for each statement
    std::vector<Setting> overrides; ///< settings by the option `--set`, which replace the netlist's settings
    std::string kind;
    std::optional<Location> used; ///< place of the `use` statement that names the kind
    std::size_t node = nowhere;
    Location placed;
};

/// Describes a piece of wire between two links, or a crosspoint. A crosspoint connects two links of one crossbar
/// switch.
struct DraftWire {
    LinkEnd a, b;
    std::size_t connection = nowhere;
    Location at;
};

/// Holds a statement that puts a device into a slot of a bus, such as `connect sun.bus[0] to vme.slot[1];`.
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

/// Holds a statement such as `place p.out on t.link[2];`, which places an end of a channel on a link. For an edge
/// instead of a link, `where.link` is -1. For a bus, `where.link` is `bus_port`.
struct DraftPlacement {
    LinkEnd where;
    Location at;
};

/// Describes a fault of a device, of the wire at a link, or of the wire of a connection. complete_faults() later sets
/// `fault.connection`, the index of the wire.
struct DraftFault {
    Fault fault;
    std::size_t connection = nowhere; ///< index in Draft::connections
    Location at;                      ///< place in the statement where the failing device, link or connection is named
};

/// Holds a statement such as `place c1 on c2;`, which places the channel with the connection `c1` on a wire.
struct DraftConnectionPlacement {
    std::size_t wire = nowhere; ///< index of the wire's connection, `c2`
    Location at;
};

struct Draft {
    std::vector<Node> nodes;
    std::vector<int> links; ///< number of links of each node
    /// Holds the places of attributes that are set after the declaration of a node, as by `t[1] (rank = 0);`. The key
    /// is the node and the attribute's name.
    std::map<std::pair<std::size_t, std::string>, Location> node_settings;
    std::vector<DraftConnection> connections;
    std::vector<DraftEdgeChannel> edge_channels;
    std::vector<DraftProcess> processes;
    std::vector<DraftWire> wires, crosspoints;
    std::vector<DraftAttachment> attachments;
    std::vector<DraftChannel> channels;
    std::map<std::pair<std::size_t, std::string>, std::vector<DraftPlacement>>
        placements; ///< key: process and port. Several placements of one port, on links of several nodes, state a
                    ///< route.
    std::map<std::size_t, DraftConnectionPlacement>
        connection_placements; ///< key: index of the channel's connection, `c1`
    std::vector<DraftFault> faults;
    std::string default_kind; ///< kind of the processes that no other `use` names; set by `use "kind" for process;`
    Location default_used;
    std::size_t things = 0;
    std::vector<SetByOption> set;
};

} // namespace placedpar
