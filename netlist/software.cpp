#include "netlist/software.hpp"

#include "netlist/network/names.hpp"
#include "netlist/runnable.hpp"

#include <string_view>

namespace placedpar {

namespace {

/// Returns the kind of the process. REQUIRES: the network can be run.
const ProcessKind& kind_of(const ProcessInstance& process, const Catalogue& catalogue) {
    return *catalogue.find(process.kind);
}

const PortDescription& port_of(const ProcessInstance& process, std::string_view name, const Catalogue& catalogue) {
    return *kind_of(process, catalogue).port(base_name(name));
}

} // namespace

Software::Software(const Network& network, const Catalogue& catalogue, std::uint64_t seed)
    : network_(network), catalogue_(catalogue), seed_(seed) {
    require_runnable(network, catalogue);
    for (const NetworkChannel& channel : network.channels) {
        const ChannelEnd& end = channel.from.at_edge() ? channel.to : channel.from;
        channels_.push_back(port_of(network.processes[end.process], end.port, catalogue).make_channel(channel.name));
    }
}

void Software::start(Simulation& simulation, const std::vector<Executive*>& executives) {
    for (std::size_t i = 0; i < network_.processes.size(); ++i)
        processes_.push_back(&start(simulation, i, executives[network_.processes[i].node]));
    expect_partners(processes_);
}

void Software::start_natively(Simulation& simulation, const std::vector<bool>& nodes, Executive* executive) {
    for (std::size_t i = 0; i < network_.processes.size(); ++i)
        processes_.push_back(nodes[network_.processes[i].node] ? &start(simulation, i, executive) : nullptr);
}

void Software::expect_partners(const std::vector<Process*>& all) {
    for (std::size_t i = 0; i < channels_.size(); ++i) {
        if (const ChannelEnd& from = network_.channels[i].from; !from.at_edge() && all[from.process])
            channels_[i]->expect_outputter(*all[from.process]);
        if (const ChannelEnd& to = network_.channels[i].to; !to.at_edge() && all[to.process])
            channels_[i]->expect_inputter(*all[to.process]);
    }
}

Process& Software::start(Simulation& simulation, std::size_t index, Executive* executive) {
    const ProcessInstance& process = network_.processes[index];
    std::vector<ProcessEnvironment::Port> ports;
    for (const PortBinding& binding : process.ports)
        ports.push_back({binding.port, channels_[binding.channel].get()});
    ProcessEnvironment& environment =
        environments_.emplace_back(network_, index, std::move(ports), seed_, measurements_);
    return simulation.process(
        process.name, [&environment, body = kind_of(process, catalogue_).body] { body(environment); }, executive,
        process.high_priority ? Priority::high : Priority::low);
}

} // namespace placedpar
