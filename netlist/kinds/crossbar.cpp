#include "runtime/hardware/crossbar.hpp"
#include "netlist/kinds/devices.hpp"
#include "netlist/kinds/machine_node.hpp"

#include <algorithm>
#include <set>

namespace placedpar {

namespace {

class CrossbarNode final : public MachineNode {
public:
    CrossbarNode(MachineParts& parts, std::size_t index)
        : MachineNode(parts, index), crossbar_(simulation().add<hardware::Crossbar>(node().name)) {}

    Executive* executive() override { return &crossbar_; }
    std::int64_t crossing_delay() const override { return hardware::Crossbar::crossing_delay; }
    void lead_on(hardware::Link& link, const SwitchCrossing& crossing) override {
        crossbar_.lead_on(link, crossing.from_link, crossing.to_link);
    }

    void report(MachineUse& use) const override {
        if (!is_set_at_run_time(network(), index()))
            return;
        SwitchUse& row =
            use.switches.emplace_back(SwitchUse{node().name, crossbar_.commands(), crossbar_.connections(), {}});
        for (const hardware::Crossbar::Loss& loss : crossbar_.losses())
            row.losses.push_back(use_of(loss));
    }

private:
    SwitchUse::Loss use_of(const hardware::Crossbar::Loss& loss) const {
        auto link = static_cast<std::size_t>(std::ranges::find(parts().links, loss.link) - parts().links.begin());
        const RouteHop hop{link, loss.leaves_a};
        const hardware::FaultEffect::Hit& first = *loss.effect.first;
        return {.from = link_name(network().nodes, begin_of(hop, network().connections)),
                .to = link_name(network().nodes, end_of(hop, network().connections)),
                .bytes = loss.effect.bytes_lost,
                .acknowledges = loss.effect.acknowledges_lost,
                .first = {first.at, first.channel, first.acknowledge, first.byte},
                .output = loss.output,
                .state = loss.state};
    }

    hardware::Crossbar& crossbar_;
};

/// Returns the names of a switch's tracks in a trace of a run: one track for each output of a switch that a program
/// sets. The track shows which input is connected to the output.
std::vector<std::string> tracks_of_outputs(const Network& network, std::size_t node) {
    if (!is_set_at_run_time(network, node))
        return {};
    std::set<int> outputs;
    for (const LinkConnection& connection : network.connections)
        for (const SwitchCrossing& crossing : connection.crossings)
            if (connection.at_run_time && crossing.node == node)
                outputs.insert({crossing.from_link, crossing.to_link});
    std::vector<std::string> names;
    for (int link : outputs)
        names.push_back(link_name(network.nodes, {node, link}));
    return names;
}

} // namespace

/// Describes the C004, a crossbar switch. Drawings for Graphviz omit a C004 that no program sets. A wire through such
/// switches is drawn from end to end, with the number of switches in its label.
DeviceKind crossbar() {
    return {.name = "c004",
            .noun = "a switch",
            .about = "A crossbar switch: its crosspoints connect its links to each other. If its link `config` leads "
                     "to a processor, a program sets the crosspoints during the run.",
            .models = {{.name = "C004", .links = hardware::Crossbar::links}},
            .links = LinkRole::crosses,
            .logic = "csp.switch_logic",
            .tracks = tracks_of_outputs,
            .make = make_device<CrossbarNode>,
            .drawing = {.shape = Drawing::Shape::crossed_box,
                        .frame = "#4b6b3b",
                        .heading = "#dfeed6",
                        .legend = "crossbar switch"}};
}

} // namespace placedpar
