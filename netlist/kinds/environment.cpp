#include "netlist/kinds/environment.hpp"

#include "netlist/network/network.hpp"
#include "text/user_error.hpp"

namespace placedpar {

ProcessEnvironment::ProcessEnvironment(const Network& network, std::size_t index, std::vector<Port> ports,
                                       std::uint64_t seed, std::vector<Measurement>& measurements)
    : network_(network), index_(index), process_(network.processes[index].name),
      parameters_(network.processes[index].parameters), ports_(std::move(ports)), seed_(seed),
      measurements_(measurements) {}

AnyChannel* ProcessEnvironment::find(std::string_view port) const {
    for (const Port& candidate : ports_)
        if (candidate.name == port)
            return candidate.channel;
    return nullptr;
}

AnyChannel& ProcessEnvironment::require(std::string_view port) const {
    if (AnyChannel* channel = find(port))
        return *channel;
    if (connected(port))
        throw UserError(fmt::format("\"{}\" is one channel of this kind, and no array", port));
    throw std::logic_error(fmt::format("process {} has no port {}", process_, port));
}

std::vector<AnyChannel*> ProcessEnvironment::all(std::string_view port) const {
    if (AnyChannel* channel = find(port))
        return {channel};
    std::vector<AnyChannel*> channels;
    for (std::size_t i = 0; AnyChannel* channel = find(fmt::format("{}[{}]", port, i)); ++i)
        channels.push_back(channel);
    return channels;
}

} // namespace placedpar
