#include "netlist/complete/complete.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar {

namespace {

/// From what is attached to buses to the ways over them: from each master to the memory of each bus master, and from
/// the master that uses a link adapter to what is at the other end of its link.
class Buses {
public:
    explicit Buses(Completion& c) : c_(c) {}

    void run() {
        for (const DraftAttachment& each : c_.draft.attachments)
            attach(each);
        check_adapters_without_bus();
        if (c_.buses_refused = c_.reporter.failed(); c_.buses_refused)
            return;
        for (std::size_t slave = 0; slave < attachments().size(); ++slave)
            if (kind_of(slave).bus == BusRole::adapter)
                lead_over_adapter(slave);
        for (std::size_t master = 0; master < attachments().size(); ++master)
            for (std::size_t slave = 0; slave < attachments().size(); ++slave)
                if (shares_memory_with(slave, master))
                    add_way(master, slave, nowhere);
    }

private:
    std::vector<BusAttachment>& attachments() const { return c_.network.attachments; }
    const Node& node(std::size_t attachment) const { return c_.draft.nodes[attachments()[attachment].node]; }
    const DeviceKind& kind_of(std::size_t attachment) const { return *node(attachment).kind; }

    /// Of two bus masters each reaches the other's memory: one way, from the one that is attached first.
    bool shares_memory_with(std::size_t slave, std::size_t master) const {
        return slave != master && attachments()[slave].bus == attachments()[master].bus &&
               kind_of(slave).bus == BusRole::bus_master && kind_of(master).is_master() &&
               (kind_of(master).bus == BusRole::workstation || master < slave);
    }

    void attach(const DraftAttachment& draft) {
        BusAttachment attachment{
            .node = draft.node, .bus = draft.bus, .slot = draft.slot, .name = {}, .connected = draft.at};
        if (draft.connection != nowhere && !take_attributes(attachment, c_.draft.connections[draft.connection]))
            return;
        if (c_.draft.nodes[draft.node].kind->is_master() && !check_place(attachment))
            return;
        attachments().push_back(std::move(attachment));
    }

    bool take_attributes(BusAttachment& attachment, const DraftConnection& connection) {
        bool master = c_.draft.nodes[attachment.node].kind->is_master();
        attachment.name = connection.name;
        if (connection.bits_per_second || connection.metres)
            return refuse(attachment.connected,
                          fmt::format("the connection \"{}\" leads to a bus, which has neither a link's speed nor its "
                                      "length",
                                      connection.name),
                          "its attributes are level and release", connection);
        if (!master && (connection.level || connection.release))
            return refuse(attachment.connected,
                          fmt::format("\"{}\" never asks for the bus: it has no {}",
                                      c_.draft.nodes[attachment.node].name, connection.level ? "level" : "release"),
                          "workstations and bus masters do", connection);
        attachment.level = connection.level.value_or(attachment.level);
        attachment.on_request = connection.release == "ROR";
        return true;
    }

    bool refuse(const Location& at, std::string message, std::string hint, const DraftConnection& connection) {
        c_.reporter.error(at, std::move(message), std::move(hint), {{"declared here", connection.declared}});
        return false;
    }

    /// A bus grant passes a slot once, and an arbiter of one level sees no other.
    bool check_place(const BusAttachment& attachment) {
        const Node& bus = c_.draft.nodes[attachment.bus];
        for (const BusAttachment& other : attachments())
            if (other.bus == attachment.bus && other.slot == attachment.slot &&
                c_.draft.nodes[other.node].kind->is_master()) {
                c_.reporter.error(attachment.connected,
                                  fmt::format("\"{}\" and \"{}\" are both masters in slot {} of \"{}\"",
                                              c_.draft.nodes[other.node].name, c_.draft.nodes[attachment.node].name,
                                              other.slot, bus.name),
                                  "a slot holds one master, and any number of link adapters",
                                  {{"first connected here", other.connected}});
                return false;
            }
        bool single = bus.attributes.at("arbiter") == Value("SGL");
        if (single && attachment.level != 3)
            c_.reporter.error(attachment.connected,
                              fmt::format("\"{}\" asks at level {}, but the arbiter of \"{}\" is SGL",
                                          c_.draft.nodes[attachment.node].name, attachment.level, bus.name),
                              "it knows level 3 only; \"PRI\" and \"RRS\" know all four");
        return !single || attachment.level == 3;
    }

    void check_adapters_without_bus() {
        for (std::size_t i = 0; i < c_.draft.nodes.size(); ++i)
            if (const Node& adapter = c_.draft.nodes[i];
                adapter.kind->bus == BusRole::adapter && !is_on_bus(c_.network, i) && !c_.reporter.failed())
                c_.reporter.error(adapter.declared,
                                  fmt::format("the link adapter \"{}\" is connected to no bus", adapter.name),
                                  fmt::format("connect {}.bus[0] to vme.slot[...];", adapter.name));
    }

    void lead_over_adapter(std::size_t slave) {
        auto wire = c_.connection_at.find({attachments()[slave].node, 0});
        if (wire == c_.connection_at.end())
            return; // its link leads nowhere, as that of one which is not used
        if (const LinkConnection& led = c_.network.connections[wire->second]; led.at_run_time)
            return c_.reporter.error(
                led.connected,
                fmt::format("a program would connect the link of the adapter \"{}\" during the run", node(slave).name),
                "an adapter leads to one processor for the whole run");
        if (std::size_t master = master_of(slave); master != nowhere)
            add_way(master, slave, wire->second);
    }

    /// Whose program uses the adapter; nowhere after having reported that this is not clear.
    std::size_t master_of(std::size_t slave) {
        const Node& adapter = node(slave);
        const auto& named = std::get<std::string>(adapter.attributes.at("master"));
        std::vector<std::size_t> masters, workstations;
        for (std::size_t i = 0; i < attachments().size(); ++i)
            if (attachments()[i].bus == attachments()[slave].bus && kind_of(i).is_master() &&
                (named.empty() || node(i).name == named)) {
                masters.push_back(i);
                if (kind_of(i).bus == BusRole::workstation)
                    workstations.push_back(i);
            }
        const auto& candidates = workstations.empty() ? masters : workstations;
        if (candidates.size() == 1)
            return candidates.front();
        refuse_master(adapter, c_.draft.nodes[attachments()[slave].bus], named, candidates);
        return nowhere;
    }

    void refuse_master(const Node& adapter, const Node& bus, const std::string& named,
                       const std::vector<std::size_t>& candidates) {
        if (!named.empty())
            c_.reporter.error(adapter.declared,
                              fmt::format("the master of the link adapter \"{}\" is \"{}\", which is no master on its "
                                          "bus \"{}\"",
                                          adapter.name, named, bus.name),
                              "workstations and bus masters on the bus are");
        else if (candidates.empty())
            c_.reporter.error(
                adapter.declared,
                fmt::format("nobody on the bus \"{}\" can use the link adapter \"{}\"", bus.name, adapter.name),
                "a workstation or a bus master does: connect sun.bus[0] to " + bus.name + ".slot[1];");
        else
            c_.reporter.error(adapter.declared,
                              fmt::format("which master uses the link adapter \"{}\", \"{}\" or \"{}\"?", adapter.name,
                                          node(candidates[0]).name, node(candidates[1]).name),
                              fmt::format("{} (master = \"{}\") ...;", adapter.type, node(candidates[0]).name));
    }

    void add_way(std::size_t master, std::size_t slave, std::size_t wire) {
        LinkConnection way;
        way.a = {attachments()[master].node, bus_port};
        way.b = {attachments()[slave].node, bus_port};
        if (wire != nowhere) {
            const LinkConnection& leads = c_.network.connections[wire];
            way.b = leads.a.node == way.b.node ? leads.b : leads.a;
            way.bits_per_second = leads.bits_per_second;
        }
        if (way.b.at_edge())
            return; // nobody is behind it
        way.connected = attachments()[slave].connected;
        way.over_bus = BusWay{master, slave, wire};
        c_.network.connections.push_back(std::move(way));
    }

    Completion& c_;
};

} // namespace

void complete_buses(Completion& completion) { Buses(completion).run(); }

} // namespace placedpar
