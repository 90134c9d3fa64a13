#include "netlist/complete/complete.hpp"

#include "netlist/kinds/own_code.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace placedpar {

namespace {

/// Adds the ways over buses, the paths from masters to slaves, to the connections of the network. The DeviceKind of a
/// bus computes the ways from the devices attached to the bus.
class Buses {
public:
    explicit Buses(Completion& c) : c_(c) {}

    void run() {
        for (const DraftAttachment& each : c_.draft.attachments)
            attach(each);
        check_adapters_without_bus();
        if (c_.buses_refused = c_.reporter.failed(); c_.buses_refused)
            return;
        for (const BusWay& way : all_ways())
            add_way(way);
    }

private:
    std::vector<BusAttachment>& attachments() const { return c_.network.attachments; }
    const std::vector<Node>& nodes() const { return c_.network.nodes; }

    void attach(const DraftAttachment& draft) {
        BusAttachment attachment{
            .node = draft.node, .bus = draft.bus, .slot = draft.slot, .name = {}, .connected = draft.at};
        if (draft.connection != nowhere && !take_attributes(attachment, c_.draft.connections[draft.connection]))
            return;
        const auto& takes = nodes()[draft.bus].kind->medium->takes;
        auto is_taken = [&] { return takes(attached_, attachment); };
        if (!takes || ask_device(nodes()[draft.bus], is_taken))
            attachments().push_back(std::move(attachment));
    }

    bool take_attributes(BusAttachment& attachment, const DraftConnection& connection) {
        bool master = c_.network.nodes[attachment.node].kind->is_master();
        attachment.name = connection.name;
        if (connection.bits_per_second || connection.metres)
            return refuse(
                attachment.connected,
                fmt::format("the connection \"{}\" leads to a bus, so it cannot have a link speed or a length",
                            connection.name),
                "a connection to a bus has the attributes level and release", connection);
        if (!master && (connection.level || connection.release))
            return refuse(
                attachment.connected,
                fmt::format("\"{}\" never requests the bus, so its connection cannot have the attribute \"{}\"",
                            c_.network.nodes[attachment.node].name, connection.level ? "level" : "release"),
                "only workstations and bus masters request a bus", connection);
        attachment.level = connection.level.value_or(attachment.level);
        attachment.on_request = connection.release == "ROR";
        return true;
    }

    bool refuse(const Location& at, std::string message, std::string hint, const DraftConnection& connection) {
        c_.reporter.error(at, std::move(message), std::move(hint), {{"declared here", connection.declared}});
        return false;
    }

    void check_adapters_without_bus() {
        for (std::size_t i = 0; i < c_.network.nodes.size(); ++i)
            if (const Node& adapter = c_.network.nodes[i];
                adapter.kind->bus == BusRole::adapter && !is_on_bus(c_.network, i) && !c_.reporter.failed())
                c_.reporter.error(adapter.declared,
                                  fmt::format("the link adapter \"{}\" is not connected to a bus", adapter.name),
                                  fmt::format("connect {}.bus[0] to vme.slot[...];", adapter.name));
    }

    /// Returns the ways over all buses: ways to link adapters first, in the order of attachment, then ways to memory.
    std::vector<BusWay> all_ways() const {
        std::vector<BusWay> all;
        for (std::size_t i = 0; i < nodes().size(); ++i)
            if (const auto& medium = nodes()[i].kind->medium; medium && medium->ways)
                std::ranges::copy(ask_device(nodes()[i], [&] { return medium->ways(attached_, i); }),
                                  std::back_inserter(all));
        auto place = [](const BusWay& way) {
            bool in_memory = way.wire == nowhere;
            return std::tuple(in_memory, in_memory ? way.master : 0, way.slave);
        };
        std::ranges::sort(all, {}, place);
        return all;
    }

    void add_way(const BusWay& over_bus) {
        LinkConnection way;
        way.a = {attachments()[over_bus.master].node, bus_port};
        way.b = {attachments()[over_bus.slave].node, bus_port};
        if (over_bus.wire != nowhere) {
            const LinkConnection& leads = c_.network.connections[over_bus.wire];
            way.b = leads.a.node == way.b.node ? leads.b : leads.a;
            way.bits_per_second = leads.bits_per_second;
        }
        if (way.b.at_edge())
            return; // the way leads to an edge
        way.connected = attachments()[over_bus.slave].connected;
        way.over_bus = over_bus;
        c_.network.connections.push_back(std::move(way));
    }

    Completion& c_;
    Attached attached_{c_.network, c_.connection_at, c_.reporter};
};

} // namespace

void complete_buses(Completion& completion) { Buses(completion).run(); }

} // namespace placedpar
