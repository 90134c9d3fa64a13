#include "monitor/service/peers.hpp"

#include <iterator>

namespace placedpar::monitor {

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
