#include "monitor/service/newcomers.hpp"

#include <algorithm>
#include <tuple>
#include <vector>

namespace placedpar::monitor {

std::optional<std::string> Newcomers::oldest(const std::function<bool(const std::string&)>& idle,
                                             Clock::time_point before) const {
    std::optional<std::string> oldest;
    Clock::time_point since = before;
    for (const auto& [machine, time] : since_)
        if (time < since && idle(machine)) {
            oldest = machine;
            since = time;
        }
    return oldest;
}

std::optional<std::string> Newcomers::least(const std::function<bool(const std::string&)>& idle,
                                            const std::function<std::string(const std::string&)>& peer,
                                            const std::function<std::size_t(const std::string&)>& samples) const {
    // Machines that were restored have no peer: each counts alone, so that a flood after a restart does not displace
    // them.
    auto group = [&](const std::string& machine) {
        std::string its_peer = peer(machine);
        return its_peer.empty() ? "restored " + machine : its_peer;
    };
    std::map<std::string, std::vector<std::tuple<std::size_t, Clock::time_point, std::string>>> of_peers;
    for (const auto& [machine, time] : since_)
        if (idle(machine))
            of_peers[group(machine)].emplace_back(samples(machine), time, machine);
    auto most = std::ranges::max_element(of_peers, {}, [](const auto& each) { return each.second.size(); });
    if (most == of_peers.end())
        return std::nullopt;
    return std::get<std::string>(*std::ranges::min_element(most->second));
}

} // namespace placedpar::monitor
