#include "monitor/service/newcomers.hpp"

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

} // namespace placedpar::monitor
