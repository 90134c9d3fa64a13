#include "observe/critical_path/waits.hpp"

#include <algorithm>
#include <utility>

namespace placedpar {

std::string Account::most_waited_for() const {
    auto most = std::ranges::max_element(waiting_for, {}, [](const auto& each) { return each.second; });
    return most == waiting_for.end() || most->second == Time{0} ? "" : most->first;
}

void Accounts::settle(const std::string& process, Time now) {
    State& state = states_[process];
    Account& account = accounts_[process];
    Time passed = now - std::exchange(state.since, now);
    if (state.components[Activity::computing] > 0)
        account.computing += passed;
    else if (state.components[Activity::moving] > 0)
        account.communicating += passed;
    else if (state.components[Activity::ready] > 0)
        account.ready += passed;
    else if (std::ranges::any_of(state.components,
                                 [](const auto& each) { return is_waiting(each.first) && each.second > 0; }))
        state.unexplained += passed;
}

void Accounts::turn(const std::string& process, Activity from, Activity to, Time now) {
    settle(process, now);
    --states_[process].components[from];
    ++states_[process].components[to];
}

void Accounts::explain(const std::string& process, const std::string& partner, Time together, Time now) {
    settle(process, now);
    Account& account = accounts_[process];
    Time waited = std::exchange(states_[process].unexplained, Time{0});
    if (partner.empty()) {
        account.delayed += waited;
        return;
    }
    Time moved = std::min(waited, now - together);
    account.communicating += moved;
    account.waiting += waited - moved;
    account.waiting_for[partner] += waited - moved;
}

void Accounts::close(Time now) {
    for (auto& [process, state] : states_) {
        settle(process, now);
        accounts_[process].waiting += std::exchange(state.unexplained, Time{0});
    }
}

} // namespace placedpar
