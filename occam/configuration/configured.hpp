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

/// Describes a channel, node, arc or edge of a configuration, or an array of them.
struct Object {
    std::string name;
    const Type* type = nullptr; ///< type of the object; for an array, of the whole array
    Place at;
};

/// Identifies an element of an object by its position, counted with the last subscript varying fastest.
struct Element {
    std::size_t object = 0; ///< index in Configured::objects
    std::size_t index = 0;
    auto operator<=>(const Element&) const = default;
};

/// Holds what NETWORK and MAPPING state about a node. A node with a type is a processor; a node without a type must be
/// mapped onto a processor.
struct NodeState {
    std::string type = {}; ///< "T800"; "" if it is not stated
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

/// Describes an end of a channel: the port of a process to which the configuration passes the channel. The channel is
/// an argument of the procedure's instance, and the port is the corresponding parameter of the procedure.
struct ChannelEnd {
    std::size_t process = 0;            ///< index in Configured::processes
    std::size_t port = 0;               ///< index in the ports of its kind
    std::optional<std::size_t> element; ///< index in the port's array of channels; nothing if the port is not an array
    Place at;
};

struct ChannelState {
    std::optional<ChannelEnd> output, input;
    /// These are the links by which the channel leaves its sender and arrives at its receiver, if they are stated.
    /// For a channel on an arc to an edge, only one of them is set.
    std::optional<WireEnd> leaves, arrives;
    std::optional<Element> arc;
    Place placed_at;
    bool leads_to_host = false;
};

/// Holds a parameter's value in the syntax of the netlist.
struct WrittenValue {
    std::string name, value;
    Place at;
};

/// Describes an instance of a procedure on a node.
struct PlacedProcess {
    const Declaration* procedure = nullptr;
    Element node; ///< a processor, once the whole configuration has been executed
    bool high_priority = false;
    Place at, node_at;
    std::vector<WrittenValue> values = {};
};

/// Holds what a configuration describes, in the order of the text.
struct Configured {
    std::vector<Object> objects; ///< the first is the edge HOST
    std::map<Element, NodeState> nodes;
    std::vector<WrittenWire> wires;
    std::map<Element, std::size_t> wire_of_arc; ///< index in `wires` of the wire that the arc names
    std::vector<PlacedProcess> processes;
    std::vector<Element> channel_order; ///< channels in the order of their first use
    std::map<Element, ChannelState> channels;
    std::map<const Declaration*, ProcessKind> kinds; ///< kinds of the procedures; for look-up only, never iterated
};

/// Returns the number of elements of a type; 1 unless it is an array.
std::size_t count_of_elements(const Type&);
/// Returns the subscripts of an element: {2, 0}.
std::vector<std::int64_t> subscripts_of(const Configured&, const Element&);
/// Returns the name as the configuration writes it: "B003.t[2]".
std::string text_of(const Configured&, const Element&);

} // namespace placedpar::occam
