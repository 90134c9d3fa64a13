#include "monitor/service/peers.hpp"

#include <iterator>

namespace placedpar::monitor {

std::string Peers::of(const std::string& machine) const {
    auto found = introduced_.find(machine);
    return found == introduced_.end() ? "" : found->second;
}

bool Peers::may_introduce(const std::string& peer) const {
    auto found = machines_.find(peer);
    return found == machines_.end() || found->second < limits_.machines_per_peer;
}

void Peers::introduced(const std::string& peer, const std::string& machine) {
    forgotten(machine);
    introduced_[machine] = peer;
    ++machines_[peer];
}

void Peers::forgotten(const std::string& machine) {
    auto found = introduced_.find(machine);
    if (found == introduced_.end())
        return;
    if (auto count = machines_.find(found->second); --count->second == 0)
        machines_.erase(count);
    introduced_.erase(found);
}

bool Peers::take_over(const std::string& peer, Clock::time_point now) {
    for (auto each = takeovers_.begin(); each != takeovers_.end();) {
        std::deque<Clock::time_point>& times = each->second;
        while (!times.empty() && now - times.front() > std::chrono::minutes(1))
            times.pop_front();
        each = times.empty() ? takeovers_.erase(each) : std::next(each);
    }
    auto& times = takeovers_[peer];
    if (times.size() >= limits_.takeovers_per_peer)
        return false;
    times.push_back(now);
    return true;
}

} // namespace placedpar::monitor
