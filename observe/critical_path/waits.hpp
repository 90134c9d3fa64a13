#pragma once

#include "runtime/process.hpp"
#include "runtime/time.hpp"

#include <map>
#include <string>

namespace placedpar {

/// How the time of a process went by, with the components of its PARs. It computes while one of them does; else it
/// communicates while one of them moves words over a bus, or waits for the bus; else it is ready while one of them is;
/// else all of them wait. The times add up to its life.
struct Account {
    Time computing{}, ready{}, communicating{}, delayed{}, waiting{};
    std::map<std::string, Time> waiting_for; ///< partners; parts of `waiting`, all but a last wait that never ended

    Time life() const { return computing + ready + communicating + delayed + waiting; }
    /// For whom it waited longest; "" for nobody.
    std::string most_waited_for() const;
};

/// Keeps the accounts of all processes at the outermost level, by name.
class Accounts {
public:
    /// A component, or the process itself, turns from one to another.
    void turn(const std::string& process, Activity from, Activity to, Time now);
    /// A wait ends: since `together` it communicated with the partner; "" for a delay.
    void explain(const std::string& process, const std::string& partner, Time together, Time now);
    void close(Time now);

    const std::map<std::string, Account>& all() const { return accounts_; }

private:
    struct State {
        std::map<Activity, int> components; ///< that do this
        Time since{};
        Time unexplained{}; ///< waited, before it is known for whom
    };
    void settle(const std::string& process, Time now);

    std::map<std::string, Account> accounts_;
    std::map<std::string, State> states_;
};

} // namespace placedpar
