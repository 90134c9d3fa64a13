#pragma once

#include "runtime/process.hpp"
#include "runtime/time.hpp"

#include <map>
#include <string>

namespace placedpar {

/// How a process, including the components of its PARs, spent its time. The process counts as computing while the
/// process or a component computes. Otherwise it counts as communicating while the process or a component moves words
/// over a bus or waits for the bus. Otherwise it counts as ready while the process or a component is ready, and as
/// waiting at all other times. A wait for a message counts as communicating once both processes are at the channel. A
/// wait for the clock counts as delayed. The times add up to the lifetime of the process.
struct Account {
    Time computing{}, ready{}, communicating{}, delayed{}, waiting{};
    /// Parts of `waiting`, by the process that was waited for; without a wait that never ended.
    std::map<std::string, Time> waiting_for;

    Time life() const { return computing + ready + communicating + delayed + waiting; }
    /// Returns the process for which this process waited longest; "" if it waited for none.
    std::string most_waited_for() const;
};

/// Keeps the accounts of all outermost processes (processes that are not components of a PAR), by name.
class Accounts {
public:
    /// Notes that the process, or one of its components, changes its activity.
    void turn(const std::string& process, Activity from, Activity to, Time now);
    /// Notes the end of a wait for `partner`. `together`: when both processes were at the channel. `partner` is "" for
    /// a delay.
    void explain(const std::string& process, const std::string& partner, Time together, Time now);
    void close(Time now);

    const std::map<std::string, Account>& all() const { return accounts_; }

private:
    struct State {
        std::map<Activity, int> components; ///< number of components by activity
        Time since{};
        Time unexplained{}; ///< time of a wait for which the partner is not known yet
    };
    void settle(const std::string& process, Time now);

    std::map<std::string, Account> accounts_;
    std::map<std::string, State> states_;
};

} // namespace placedpar
