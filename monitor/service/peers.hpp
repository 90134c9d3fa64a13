#pragma once

#include "monitor/service/limits.hpp"

#include <chrono>
#include <cstddef>
#include <deque>
#include <map>
#include <string>

namespace placedpar::monitor {

/// What each peer has taken of what there is for all: so that none can take everything. Peers are named as Caller::peer
/// is.
class Peers {
public:
    using Clock = std::chrono::steady_clock;

    explicit Peers(const ServiceLimits& limits) : limits_(limits) {}

    bool may_introduce(const std::string& peer) const;
    void introduced(const std::string& peer, const std::string& machine);
    void forgotten(const std::string& machine);
    /// The peer that introduced the machine; "" for one that was restored at the start.
    std::string of(const std::string& machine) const;

    /// One more takeover of a machine's control; false, and nothing changes, when there were too many in the last
    /// minute.
    bool take_over(const std::string& peer, Clock::time_point now);

private:
    const ServiceLimits& limits_;
    std::map<std::string, std::size_t> machines_;
    std::map<std::string, std::string> introduced_; ///< peers by machine
    std::map<std::string, std::deque<Clock::time_point>> takeovers_;
};

} // namespace placedpar::monitor
