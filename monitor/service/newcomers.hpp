#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <optional>
#include <string>

namespace placedpar::monitor {

/// Machines that have not sent a sample yet, and since when they have been there: a name costs nothing, so it is kept
/// only for a while.
class Newcomers {
public:
    using Clock = std::chrono::steady_clock;

    void add(const std::string& machine, Clock::time_point now) { since_[machine] = now; }
    /// It has sent a sample, or been forgotten.
    void remove(const std::string& machine) { since_.erase(machine); }
    /// The one that is there the longest of those that `idle` is true of, if it came before `before`.
    std::optional<std::string> oldest(const std::function<bool(const std::string&)>& idle,
                                      Clock::time_point before) const;

private:
    std::map<std::string, Clock::time_point> since_;
};

} // namespace placedpar::monitor
