#include "netlist/kinds/environment.hpp"

namespace placedpar {

AnyChannel* ProcessEnvironment::find(std::string_view port) const {
    for (const Port& candidate : ports_)
        if (candidate.name == port)
            return candidate.channel;
    return nullptr;
}

AnyChannel& ProcessEnvironment::require(std::string_view port) const {
    if (AnyChannel* channel = find(port))
        return *channel;
    throw std::logic_error(fmt::format("process {} has no port {}", process_, port));
}

std::vector<AnyChannel*> ProcessEnvironment::all(std::string_view port) const {
    std::vector<AnyChannel*> channels;
    for (std::size_t i = 0; AnyChannel* channel = find(fmt::format("{}[{}]", port, i)); ++i)
        channels.push_back(channel);
    return channels;
}

} // namespace placedpar
