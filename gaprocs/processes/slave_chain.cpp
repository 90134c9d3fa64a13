#include "gaprocs/processes/slave_chain.hpp"

#include "netlist/network/names.hpp"

#include <fmt/format.h>

namespace placedpar {

namespace {

std::string shown(const Network& network, const ChannelEnd& end) {
    return end.at_edge() ? end.port : network.processes[end.process].name + "." + end.port;
}

/// The process that passes tasks on and takes results in, and its ports for it.
struct Before {
    std::size_t process;
    const char* to;
    const char* from;
};

} // namespace

std::optional<ChannelEnd> other_end(const Network& network, std::size_t process, std::string_view port) {
    for (const PortBinding& binding : network.processes[process].ports)
        if (base_name(binding.port) == port) {
            const NetworkChannel& channel = network.channels[binding.channel];
            return binding.direction == Direction::output ? channel.to : channel.from;
        }
    return std::nullopt;
}

SlaveChain follow_slaves(const Network& network, std::size_t master) {
    SlaveChain chain;
    Before before{master, "to_slaves", "from_slaves"};
    // It ends: a slave takes its tasks from one process only, and the first of them from the master.
    while (auto tasks = other_end(network, before.process, before.to)) {
        if (tasks->at_edge() || network.processes[tasks->process].kind != "ga.slave") {
            chain.known = false;
            return chain;
        }
        std::size_t slave = tasks->process;
        auto results = other_end(network, before.process, before.from);
        if (!results || results->process != slave || results->port != "to_master") {
            const std::string &from = network.processes[before.process].name, &name = network.processes[slave].name;
            chain.known = false;
            chain.complaints.push_back(
                {before.process, before.from,
                 fmt::format("\"{0}.{1}\" leads to the slave \"{2}\", but \"{0}.{3}\" comes from \"{4}\"", from,
                             before.to, name, before.from, results ? shown(network, *results) : "nowhere"),
                 fmt::format("connect {}.to_master to {}.{};", name, from, before.from)});
            return chain;
        }
        chain.slaves.push_back(slave);
        before = {slave, "to_next", "from_next"};
    }
    return chain;
}

} // namespace placedpar
