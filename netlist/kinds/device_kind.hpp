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

/// States how a device uses the wires that lead to it.
enum class LinkRole {
    ends,    ///< wires end at the device's numbered links
    crosses, ///< the device is a switch: it joins the wires at two of its numbered links
    edge     ///< the device is an edge, where the network ends; it has no numbered links
};

/// States what a device does in a slot of a bus or another Medium. For a slot of a VMEbus, the class that simulates the
/// device must derive from MachineNode and from OnVme.
enum class BusRole {
    none,        ///< the device cannot be in a slot
    workstation, ///< a host computer; a master whose byte order differs from a transputer's
    bus_master,  ///< a transputer that is a master, and whose memory other masters can access
    adapter      ///< a link adapter: a master exchanges bytes with the device at the other end of the adapter's link by
                 ///< reading and writing the adapter's registers
};

/// States whether processes on a device take virtual time.
enum class Execution {
    none, ///< no processes can be placed on the device
    in_time,
    in_time_on_a_bus ///< processes take time only if the device is attached to a bus
};

/// Describes an attribute that a netlist gives in parentheses, as in `T800 (memory = 4M) t;`.
struct AttributeDescription {
    ParameterDescription value;    ///< name, type, unit, range and default of the attribute
    bool decimal_suffixes = false; ///< true: 20M means 20 000 000, as for a frequency; false: 20M means 20 971 520
    std::string json_name = "";    ///< key of the attribute in the JSON output
    std::function<std::string(const Value&)> drawn =
        {}; ///< returns the text of the value in a drawing, such as "2 MB"; empty: the attribute is not drawn
};

/// Describes a kind of fault, such as `silent`, which a statement like `fault t[0].link[1] silent (from = 20ms);` gives
/// to a device or a link.
struct FaultKind {
    std::string name;                                  ///< such as "halts"
    std::string about;                                 ///< one line
    std::vector<AttributeDescription> attributes = {}; ///< attributes of the fault; times are in ns
    bool silences_links =
        false; ///< for a fault of a device: all links of the device are silent from the beginning of the fault
    /// Returns the reason why a device cannot have a fault of this kind; "" if it can. Each attribute alone has already
    /// been checked. If the function is empty, the fault is always possible.
    std::function<std::string(const Network&, const Fault&)> why_not = {};

    /// Returns the attribute of this name; null if there is none.
    const AttributeDescription* attribute(std::string_view name) const;
};

/// Describes a name with which a netlist can declare devices of a kind, and the properties of these devices.
struct DeviceModel {
    std::string name; ///< the name in a netlist, such as "B404"
    std::string type =
        "";        ///< type of the nodes, such as "T800" for a B404, a module with a T800; "": the type is `name`
    int links = 0; ///< number of links
    std::map<std::string, Value, std::less<>> attributes = {}; ///< attributes that differ from the kind's defaults
    bool overlapped_acknowledge = true;                        ///< the links acknowledge a byte while the byte arrives
    bool floating_point_unit = true;                           ///< see Node::floating_point_unit
    bool needs_type = false; ///< the declaration must have the attribute `type`, which names another model of the kind
};

/// Holds what a Medium needs to check the devices in its slots while a netlist is read.
struct Attached {
    const Network& network; ///< has all nodes and wires, and the attachments of devices to slots so far
    const std::map<std::pair<std::size_t, int>, std::size_t>& connection_at; ///< index of each wire; key: node and link
    Reporter& reporter;

    const Node& node(std::size_t attachment) const { return network.nodes[network.attachments[attachment].node]; }
};

/// Describes a device with slots, such as a bus or a ring, that carries messages between the devices in its slots.
struct Medium {
    int slots = 1; ///< number of slots; they are numbered from 1
    bool broadcasts =
        false; ///< a netlist may place channels on the device; their messages are broadcast to link adapters
    bool shares_ways = false; ///< any number of channels may use one way, and their messages are not split into packets
    /// Returns whether a device can be attached in addition to the devices that are already attached. Otherwise reports
    /// the reason. If the function is empty, every device is accepted.
    std::function<bool(const Attached&, const BusAttachment&)> takes = {};
    /// Returns the ways over this device, without duplicates: the paths on which a master reaches a slave. Reports each
    /// attached device that needs a way and has none.
    std::function<std::vector<BusWay>(const Attached&, std::size_t node)> ways;
};

/// Describes the look of a device in the drawing of a network.
struct Drawing {
    enum class Shape { box, crossed_box, ellipse };
    Shape shape = Shape::box;
    std::string frame = "", heading = ""; ///< colours: of the border, and of the background of the name
    bool in_first_row = false;
    std::string legend = ""; ///< name of the device in the legend of the drawing
};

/// Describes a kind of device, such as transputers or VMEbuses. The code that reads, checks, prints and simulates
/// netlists knows devices only from these descriptions. A switch is a device, too, and so is an edge, the place where
/// the network ends.
struct DeviceKind {
    std::string name;  ///< name in the JSON output, such as "processor"
    std::string noun;  ///< name in messages, such as "a processor"
    std::string about; ///< one line
    std::vector<DeviceModel> models = {};
    std::string refusal = ""; ///< why a netlist cannot declare such devices; "" if it can
    LinkRole links = LinkRole::ends;
    std::vector<AttributeDescription> attributes = {};
    std::vector<std::string> kept = {}; ///< names of attributes that only INMOS's configurer icconf uses: they are read
                                        ///< and printed, and have no effect
    Execution executes = Execution::none; ///< a device for which this is not `none` must be connected to another node
    /// For a switch that programs can set during the run: the kind of the process that obeys the commands from the
    /// switch's link `config`. Only one process, of this kind, can be placed on the switch. "" for any other device.
    std::string logic = "";
    bool passes_channels_on = false; ///< channels between other nodes may lead through the device; the attributes
                                     ///< "routecost" and "linkquota" are then required
    /// Returns the reason why a device with these attributes is impossible; "" if it is possible. Each attribute alone
    /// has already been checked. If the function is empty, every device is possible.
    std::function<std::string(const Node&)> why_not = {};
    BusRole bus = BusRole::none;
    std::optional<Medium> medium = {};  ///< set for a device with slots
    std::vector<FaultKind> faults = {}; ///< faults of the device, in addition to faults of its links
    /// Returns the names of the device's own tracks in a trace of a run, in addition to the tracks of processes and
    /// links. A track shows the trace events whose PlaceTaken::place is its name. If the function is empty, the device
    /// has no own tracks.
    std::function<std::vector<std::string>(const Network&, std::size_t node)> tracks = {};
    /// Makes the object that simulates the device in a run. If the function is empty, the device does nothing in a run.
    std::function<std::unique_ptr<MachineNode>(MachineParts&, std::size_t node)> make = {};
    Drawing drawing = {};
    /// True if this kind is part of a user's program that is built on PlacedPar. An exception from the kind is then an
    /// error of that program.
    bool is_own = false;

    /// Returns the attribute of this name; null if there is none.
    const AttributeDescription* attribute(std::string_view name) const;
    /// Returns whether the device is a master on a bus.
    bool is_master() const { return bus == BusRole::workstation || bus == BusRole::bus_master; }
    /// Returns whether the device is a switch that a program can set, over a wire to its link `config`.
    bool is_set_by_link() const { return !logic.empty(); }
    /// Returns whether the device always executes something in virtual time: processes, or the commands to a switch.
    bool has_executive() const { return executes == Execution::in_time || is_set_by_link(); }
    /// Returns whether a declaration of such a device may give attributes.
    bool has_attributes() const { return !attributes.empty() || !kept.empty(); }
};

/// Returns whether processes on the node take virtual time.
bool executes_in_time(const Network& network, std::size_t node);

/// Returns the number of nodes that execute processes in virtual time, without workstations.
std::size_t count_processors(const Network& network);

/// Describes a type with which a netlist can declare nodes: a model of a kind of device, or a type that a `define`
/// statement makes.
struct NodeType {
    Node preset; ///< a node that is copied for each declared node, which then gets its name
    int links = 0;
    bool needs_type = false; ///< see DeviceModel::needs_type
};

/// Returns the type of a model: its attributes are those of the model, otherwise the defaults of the kind.
NodeType node_type(const std::shared_ptr<const DeviceKind>& kind, const DeviceModel& model);

} // namespace placedpar
