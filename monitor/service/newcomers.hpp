#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <optional>
#include <string>

namespace placedpar::monitor {

/// Machines that have sent few samples or none, and since when they have been there: a name and a few samples cost
/// nothing, so one without samples is kept only for a while, and one with few only while there is room.
class Newcomers {
public:
    using Clock = std::chrono::steady_clock;

    void add(const std::string& machine, Clock::time_point now) { since_[machine] = now; }
    /// It is known by now, or has been forgotten.
    void remove(const std::string& machine) { since_.erase(machine); }
    /// The one that is there the longest of those that `idle` is true of, if it came before `before`.
    std::optional<std::string> oldest(const std::function<bool(const std::string&)>& idle,
                                      Clock::time_point before) const;
    /// The one to be forgotten for another, of those that `idle` is true of: of the peer with most of them, by `peer`,
    /// that with the fewest samples, then the oldest.
    std::optional<std::string> least(const std::function<bool(const std::string&)>& idle,
                                     const std::function<std::string(const std::string&)>& peer,
                                     const std::function<std::size_t(const std::string&)>& samples) const;

private:
    std::map<std::string, Clock::time_point> since_;
};

} // namespace placedpar::monitor
