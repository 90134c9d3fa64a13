#pragma once

#include "netlist/kinds/process_kind.hpp"
#include "occam/language/tree.hpp"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace placedpar::occam {

/// Describes a channel, node, arc or edge that a configuration declares, or an array of these.
struct Object {
    std::string name;
    const Type* type = nullptr; ///< type; for an array, that of the whole array
    Place at;
};

/// Identifies an object, or an element of an array, by its position in the array. The last subscript varies fastest.
struct Element {
    std::size_t object = 0; ///< index in Configured::objects
    std::size_t index = 0;
    auto operator<=>(const Element&) const = default;
};

/// Holds what the parts NETWORK and MAPPING of a configuration state about a node. A node with a type is a processor. A
/// node without a type is a logical processor, which must be mapped onto a processor.
struct NodeState {
    std::string type = {}; ///< such as "T800"; "" if the configuration states no type
    std::int64_t memory_bytes = 0;
    Place type_at = {}, memory_at = {};
    std::optional<Element> onto = {};
    Place onto_at = {};
    bool high_priority = false;
};

struct WireEnd {
    Element element = {}; ///< a node or an edge
    bool is_edge = false;
    std::int64_t link = 0;
    Place at = {}, link_at = {};
};

struct WrittenWire {
    WireEnd a, b; ///< only `b` may be an edge
};

/// Describes an end of a channel. The configuration passes the channel as an argument to an instance of a procedure: a
/// process. The port is the corresponding parameter.
struct ChannelEnd {
    std::size_t process = 0;            ///< index in Configured::processes
    std::size_t port = 0;               ///< index in the ports of the process's kind
    std::optional<std::size_t> element; ///< index in an array of channels; nothing if the port is a single channel
    Place at;
};

struct ChannelState {
    std::optional<ChannelEnd> output, input;
    /// Hold the link by which the channel leaves its sender, and the link by which it arrives at its receiver, if the
    /// configuration states them. A channel on an arc to an edge has only one of them.
    std::optional<WireEnd> leaves, arrives;
    std::optional<Element> arc;
    Place placed_at;
    bool leads_to_host = false;
};

/// Holds the value of a parameter of a process, in the syntax of a netlist.
struct WrittenValue {
    std::string name, value;
    Place at;
};

/// Describes a process: an instance of a procedure on a node.
struct PlacedProcess {
    const Declaration* procedure = nullptr;
    Element node; ///< at first any node; after the whole configuration has been executed, the processor onto which it
                  ///< is mapped
    bool high_priority = false;
    Place at, node_at;
    std::vector<WrittenValue> values = {};
};

/// Holds what a configuration describes, in the order of the text. Configurer makes it; NetlistWriter writes it as a
/// netlist.
struct Configured {
    std::vector<Object> objects; ///< the first is the edge HOST
    std::map<Element, NodeState> nodes;
    std::vector<WrittenWire> wires;
    std::map<Element, std::size_t>
        wire_of_arc; ///< index in `wires` of the wire to which `CONNECT ... WITH arc` gives the arc's name
    std::vector<PlacedProcess> processes;
    std::vector<Element> channel_order; ///< channels in the order of their first use
    std::map<Element, ChannelState> channels;
    std::map<const Declaration*, ProcessKind>
        kinds; ///< kind of process for each procedure; never iterated, since the order is not determined
};

/// Returns the number of elements of an array type; 1 for any other type.
std::size_t count_of_elements(const Type&);
/// Returns the subscripts of an element, such as {2, 0}.
std::vector<std::int64_t> subscripts_of(const Configured&, const Element&);
/// Returns the name of an element as the configuration writes it, such as "B003.t[2]".
std::string text_of(const Configured&, const Element&);

} // namespace placedpar::occam
