#include "gaprocs/processes/peers.hpp"

#include "netlist/network/names.hpp"

#include <algorithm>
#include <iterator>

namespace placedpar {

std::vector<PortBinding> ends_of(const Network& network, std::size_t process, std::string_view port) {
    std::vector<PortBinding> ends;
    std::ranges::copy_if(network.processes[process].ports, std::back_inserter(ends),
                         [&](const PortBinding& binding) { return base_name(binding.port) == port; });
    return ends;
}

const ChannelEnd& end_beyond(const Network& network, const PortBinding& binding) {
    const NetworkChannel& channel = network.channels[binding.channel];
    return binding.direction == Direction::output ? channel.to : channel.from;
}

std::optional<ChannelEnd> other_end(const Network& network, std::size_t process, std::string_view port) {
    auto ends = ends_of(network, process, port);
    return ends.empty() ? std::nullopt : std::optional(end_beyond(network, ends.front()));
}

std::vector<Peer> peers_at(const Network& network, std::size_t process, std::string_view port) {
    std::vector<Peer> peers;
    for (const PortBinding& end : ends_of(network, process, port))
        peers.push_back({end.port, end_beyond(network, end).process});
    return peers;
}

} // namespace placedpar
