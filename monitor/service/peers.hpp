#pragma once

#include "monitor/service/limits.hpp"

#include <chrono>
#include <deque>
#include <map>
#include <string>

namespace placedpar::monitor {

/// Counts how often each peer has taken over the control of machines, to stop two control systems that take one machine
/// from each other. A peer is the computer or user from which clients come, named by Caller::peer.
class Peers {
public:
    using Clock = std::chrono::steady_clock;

    explicit Peers(const ServiceLimits& limits) : limits_(limits) {}

    /// Counts one more takeover of a machine's control. Returns false, and counts nothing, if the peer had too many in
    /// the last minute.
    bool take_over(const std::string& peer, Clock::time_point now);

private:
    const ServiceLimits& limits_;
    std::map<std::string, std::deque<Clock::time_point>> takeovers_;
};

} // namespace placedpar::monitor
