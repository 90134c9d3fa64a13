#pragma once

#include "runtime/process.hpp"
#include "runtime/time.hpp"

#include <map>
#include <string>

namespace placedpar {

/// The time of a process, including the components of its PARs, by activity. The process counts as computing while the
/// process or a component computes. Otherwise it counts as communicating while the process or a component moves words
/// over a bus or waits for the bus. Otherwise it counts as ready while the process or a component is ready, and as
/// waiting at all other times. A wait for a message counts as communicating once both processes are at the channel. A
/// wait without a partner counts as delayed. The times add up to the lifetime of the process.
struct Account {
    Time computing{}, ready{}, communicating{}, delayed{}, waiting{};
    std::map<std::string, Time> waiting_for; ///< parts of `waiting` by partner, without a wait that never ended

    Time life() const { return computing + ready + communicating + delayed + waiting; }
    /// Returns the partner for which the process waited longest; "" if it waited for no partner.
    std::string most_waited_for() const;
};

/// Keeps the accounts of all processes at the outermost level, by name.
class Accounts {
public:
    /// Notes that the process, or one of its components, changes its activity.
    void turn(const std::string& process, Activity from, Activity to, Time now);
    /// Notes the end of a wait: the process has communicated with the partner since `together`. The partner is "" for a
    /// delay.
    void explain(const std::string& process, const std::string& partner, Time together, Time now);
    void close(Time now);

    const std::map<std::string, Account>& all() const { return accounts_; }

private:
    struct State {
        std::map<Activity, int> components; ///< number of components by activity
        Time since{};
        Time unexplained{}; ///< waiting time whose partner is not known yet
    };
    void settle(const std::string& process, Time now);

    std::map<std::string, Account> accounts_;
    std::map<std::string, State> states_;
};

} // namespace placedpar
