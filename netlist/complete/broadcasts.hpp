#pragma once

#include "netlist/complete/complete.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

/// Finds the ways of the channels that the netlist places on a bus (`place p.out[i] on vme;`). A way is a path from the
/// sender over the bus and a link adapter to a receiver. The channels of one port array on one bus form a broadcast:
/// each word written on the bus reaches the link adapters of all receivers.
class Broadcasts {
public:
    /// REQUIRES: both arguments outlive this object. `load` counts the channels on each connection: see RouteSearch
    /// (netlist/complete/routes.hpp).
    Broadcasts(Completion& completion, const std::vector<std::size_t>& load) : c_(completion), load_(load) {}

    /// Holds an end of a channel, and the statement that places this end on a bus.
    struct Placed {
        const ChannelEnd& end;
        const DraftPlacement& by;
        std::size_t bus() const { return by.where.node; }
    };
    std::optional<Placed> placed(const NetworkChannel&) const;

    /// Returns the way over the bus, through an adapter, to the receiver's processor. If several ways lead to this
    /// processor, returns the way with the fewest channels. Among ways with equally many channels, returns the way to
    /// the processor's lowest link. Throws StatementRefused after reporting an error.
    RouteHop way_of(const NetworkChannel&, const Placed&) const;
    /// Reports each broadcast whose way carries another channel. REQUIRES: all channels have their placements.
    void check() const;

private:
    const LinkConnection& connection(std::size_t index) const { return c_.network.connections[index]; }
    const BusAttachment& slave_of(const LinkConnection& way) const { return attachments()[way.over_bus->slave]; }
    const std::vector<BusAttachment>& attachments() const { return c_.network.attachments; }
    const std::string& node_name(std::size_t node) const { return c_.network.nodes[node].name; }
    std::string end_name(const ChannelEnd& end) const { return c_.draft.processes[end.process].name + "." + end.port; }
    const DraftPlacement* placement_of(const ChannelEnd&) const;
    /// Returns the ways over the bus that use link adapters.
    std::vector<std::size_t> adapter_ways(std::size_t bus) const;
    bool is_master(std::size_t node, std::size_t bus) const;

    void require_output(const NetworkChannel&, const Placed&) const;
    void require_master(const NetworkChannel&, const Placed&) const;
    [[noreturn]] void refuse_receiver(const NetworkChannel&, const Placed&) const;
    std::string why_not(const NetworkChannel&, std::size_t bus) const;
    std::string hint_at_adapters(const NetworkChannel&, std::size_t bus) const;
    void check(const NetworkChannel& broadcast, const std::vector<const NetworkChannel*>& on_way) const;
    [[noreturn]] void refuse(const Location&, std::string message, std::string hint,
                             std::vector<SecondPlace> others = {}) const;

    Completion& c_;
    const std::vector<std::size_t>& load_;
};

} // namespace placedpar
