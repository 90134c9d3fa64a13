#pragma once

#include "netlist/kinds/parameter.hpp"
#include "netlist/network/network.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace placedpar {

class MachineNode;   // netlist/kinds/machine_node.hpp: the device in a run
struct MachineParts; // parts of a run; same header
class Reporter;      // text/reporter.hpp

/// States how wires end at a device.
enum class LinkRole {
    ends,    ///< numbered links, at which wires end
    crosses, ///< numbered links; a crosspoint joins the wires at two of them
    edge     ///< no links: the node is an end of the network
};

/// States what a device does in a slot of another device (Medium). If that device is a VMEbus, the MachineNode of the
/// device in the slot must also derive from OnVme.
enum class BusRole {
    none,        ///< the device cannot be in a slot
    workstation, ///< a master whose byte order differs from a transputer's
    bus_master,  ///< a transputer that is a master and shares its memory with the bus
    adapter ///< a link adapter: by its registers, a master exchanges bytes with the device at the other end of its link
};

/// States when processes on a device take time.
enum class Execution {
    none, ///< no processes can be placed on the device
    in_time,
    in_time_on_a_bus ///< processes take time only if the node is on a bus
};

/// Describes one attribute in the parentheses of a declaration.
struct AttributeDescription {
    ParameterDescription value;    ///< name, type, unit, range and default of the attribute
    bool decimal_suffixes = false; ///< 20M means 20 000 000, as for a frequency; if false, 20M means 20 971 520
    std::string json_name = "";    ///< the attribute's key in the JSON document
    std::function<std::string(const Value&)> drawn =
        {}; ///< returns the attribute's text in a drawing, such as "2 MB"; empty: not drawn
};

/// Describes a kind of fault of a device or a link. A `fault` statement names the device or link, then this kind.
struct FaultKind {
    std::string name;                                  ///< "halts"
    std::string about;                                 ///< one line
    std::vector<AttributeDescription> attributes = {}; ///< times in ns
    bool silences_links = false;                       ///< for a device: its links send nothing after the fault begins
    /// Returns the reason why the device cannot have this fault, although each attribute by itself is valid; "" if the
    /// fault is possible. An empty function means that the fault is always possible.
    std::function<std::string(const Network&, const Fault&)> why_not = {};

    /// Returns the attribute of this name; null if there is none.
    const AttributeDescription* attribute(std::string_view name) const;
};

/// Describes a name by which nodes can be declared, and the properties of such nodes.
struct DeviceModel {
    std::string name;      ///< its name in a netlist, such as "B404"
    std::string type = ""; ///< type of its nodes, such as "T800" for a B404; "": `name` is the type
    int links = 0;         ///< link[0] to link[links - 1]
    std::map<std::string, Value, std::less<>> attributes = {}; ///< attributes that differ from the kind's defaults
    bool overlapped_acknowledge = true; ///< its links send the acknowledge of a byte while the byte arrives
    bool floating_point_unit = true;    ///< see Node::floating_point_unit
    bool needs_type = false;            ///< stands for any other model of the kind, which the attribute `type` names
};

/// Holds the parts of a network that a Medium can use while the network is checked.
struct Attached {
    const Network& network; ///< has all nodes and wires, and the attachments so far
    const std::map<std::pair<std::size_t, int>, std::size_t>& connection_at; ///< the wires by node and link
    Reporter& reporter;

    const Node& node(std::size_t attachment) const { return network.nodes[network.attachments[attachment].node]; }
};

/// Describes a device with slots, such as a bus or a ring. It carries channels between the devices in its slots.
struct Medium {
    int slots = 1;            ///< slot[1] to slot[slots]
    bool broadcasts = false;  ///< channels placed on the device reach link adapters as broadcasts
    bool shares_ways = false; ///< a way carries any number of channels, without packets
    /// Returns whether the device can be attached in addition to the devices that are already attached. If not, reports
    /// why. An empty function accepts every device.
    std::function<bool(const Attached&, const BusAttachment&)> takes = {};
    /// Returns the ways (BusWay) that lead over this device from master to slave, without duplicates. Reports each
    /// attachment that needs a way but has none.
    std::function<std::vector<BusWay>(const Attached&, std::size_t node)> ways;
};

/// Describes the look of a device in the drawing of a network.
struct Drawing {
    enum class Shape { box, crossed_box, ellipse };
    Shape shape = Shape::box;
    std::string frame = "", heading = ""; ///< colours of the border, and of the background of the name
    bool in_first_row = false;
    std::string legend = ""; ///< text of the device in the legend of the drawing
};

/// Describes a kind of device: all facts needed to read, check and print a netlist with the device, and a function that
/// makes the device in a run. Switches are devices, too. An edge is also a device, although no hardware corresponds to
/// it.
struct DeviceKind {
    std::string name;  ///< its name in JSON, such as "processor"
    std::string noun;  ///< its name in messages, such as "a processor"
    std::string about; ///< one line
    std::vector<DeviceModel> models = {};
    std::string refusal = ""; ///< why the kind cannot be declared yet; "" if it can
    LinkRole links = LinkRole::ends;
    std::vector<AttributeDescription> attributes = {};
    std::vector<std::string> kept = {};   ///< attributes that only icconf uses: read and printed, but without effect
    Execution executes = Execution::none; ///< if not `none`, the nodes must be connected to other nodes
    /// Names, for a switch that is set during the run, the kind of the process that executes the commands from the
    /// switch's link `config`; "" for any other device. Only one process, of this kind, can be placed on the switch.
    std::string logic = "";
    bool passes_channels_on = false; ///< channels between other nodes may lead through the device; the kind then has
                                     ///< the attributes "routecost" and "linkquota"
    /// Returns the reason why a node with these attributes is impossible, although each attribute by itself is valid;
    /// "" if the node is possible. An empty function accepts every node.
    std::function<std::string(const Node&)> why_not = {};
    BusRole bus = BusRole::none;
    std::optional<Medium> medium = {};  ///< set for a device with slots
    std::vector<FaultKind> faults = {}; ///< faults that its nodes can have, besides the faults of their links
    /// Returns the names of the device's own tracks in a trace, besides the tracks of processes and links. Each name
    /// is the PlaceTaken::place of some trace events. If the function is empty, the device has no such tracks.
    std::function<std::vector<std::string>(const Network&, std::size_t node)> tracks = {};
    /// Makes the device in a run. If the function is empty, the device does nothing in a run.
    std::function<std::unique_ptr<MachineNode>(MachineParts&, std::size_t node)> make = {};
    Drawing drawing = {};
    /// True if a program built on PlacedPar adds this kind. An exception from the kind is then an error of that
    /// program.
    bool is_own = false;

    /// Returns the attribute of this name; null if there is none.
    const AttributeDescription* attribute(std::string_view name) const;
    /// Returns whether the device requests a bus as a master.
    bool is_master() const { return bus == BusRole::workstation || bus == BusRole::bus_master; }
    /// Returns whether a program can set the device, over a wire to the link `config`.
    bool is_set_by_link() const { return !logic.empty(); }
    /// Returns whether the device always executes in virtual time, either processes or a switch's logic.
    bool has_executive() const { return executes == Execution::in_time || is_set_by_link(); }
    /// Returns whether attributes in parentheses may follow its name in a declaration.
    bool has_attributes() const { return !attributes.empty() || !kept.empty(); }
};

/// Returns whether processes on the node take virtual time.
bool executes_in_time(const Network& network, std::size_t node);

/// Returns the number of nodes that execute processes in virtual time. Workstations are not counted.
std::size_t count_processors(const Network& network);

/// Describes a type with which nodes can be declared: a model of a kind, or a type that a `define` made.
struct NodeType {
    Node preset; ///< a node with the attributes of the type, and without a name
    int links = 0;
    bool needs_type = false; ///< see DeviceModel::needs_type
};

/// Returns the model's type, with the attributes of the kind and of the model.
NodeType node_type(const std::shared_ptr<const DeviceKind>& kind, const DeviceModel& model);

} // namespace placedpar
