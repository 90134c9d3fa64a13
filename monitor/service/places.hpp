#pragma once

#include "monitor/service/limits.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace placedpar::monitor {

/// A machine or a connection. The numbers of machines and of connections are limited.
struct Occupant {
    std::string peer;          ///< owner, as Caller::peer; "": unknown
    bool kept = false;         ///< the occupant is, or serves, a known machine, so no newcomer takes its place
    bool idle = false;         ///< not in use, so that its peer may use the place for another occupant
    std::uint64_t samples = 0; ///< number of accepted samples
    std::chrono::steady_clock::time_point heard; ///< time of the last message
};

/// Returns how many of `places` may be kept; an eighth of them always stays free for newcomers.
constexpr std::size_t most_kept(std::size_t places) { return places - (places + 7) / 8; }

/// Returns which occupant must make room for a newcomer of `peer` when all places are taken, or nullopt if the newcomer
/// is refused. Places that are not kept are shared evenly among peers. An occupant of the peer with most places goes if
/// that peer afterwards still has at least as many places as the newcomer's peer. Otherwise an idle occupant of the
/// newcomer's own peer goes. Among the occupants of a peer, idle occupants go first, then occupants with the fewest
/// samples, then occupants that have been silent longest. With `preferred`, the newcomer is a known machine and takes
/// any place that is not kept.
std::optional<std::size_t> gives_way(std::span<const Occupant> places, const std::string& peer, bool preferred);

/// The places of machines. A machine becomes known, and keeps its place, when it has sent many samples over some time.
/// This requires that a place is left that may be kept (most_kept), both in total and for the machine's peer. REQUIRES:
/// every machine named in a call has been restored or introduced, and not forgotten since.
class MachinePlaces {
public:
    using Clock = std::chrono::steady_clock;

    explicit MachinePlaces(const ServiceLimits& limits) : limits_(limits) {}

    /// Adds a machine from the state file. The machine is known if it has any samples. While it has fewer than
    /// `known_samples` samples, it loses this status if another machine becomes known and needs the place. REQUIRES:
    /// machines are restored in order of falling `samples`.
    void restored(const std::string& machine, std::uint64_t samples, Clock::time_point now);
    void introduced(const std::string& machine, const std::string& peer, Clock::time_point now);
    void forgotten(const std::string& machine);
    /// Records that the machine now has `samples` samples; 0 means that it started anew. Returns true if the machine
    /// becomes known by this call.
    bool heard(const std::string& machine, std::uint64_t samples, Clock::time_point now);

    bool known(const std::string& machine) const { return machines_.contains(machine) && machines_.at(machine).kept; }
    std::size_t introduced_by(const std::string& peer) const;
    /// Returns the machines that have sent no sample and have been silent since `then`.
    std::vector<std::string> unused_since(Clock::time_point then) const;
    /// Returns the machine to forget for a new machine of this peer, or nullopt. `only_own` limits the choice to
    /// machines that this peer introduced.
    std::optional<std::string> gives_way(const std::string& peer, bool only_own,
                                         const std::function<bool(const std::string&)>& idle) const;

private:
    struct Machine : Occupant {
        std::optional<Clock::time_point> begun; ///< time of the first sample
    };
    struct Share {
        std::size_t machines = 0, kept = 0;
    };

    void keep(Machine& machine, bool kept);
    /// Finds a place that one more machine may keep. If there is no such place, the known machine with the fewest
    /// samples gives up its place, provided that it has fewer than `known_samples` samples. Returns false if no place
    /// was found.
    bool find_kept_place();

    const ServiceLimits& limits_;
    std::map<std::string, Machine> machines_;
    std::map<std::string, Share> peers_;
    std::size_t kept_ = 0;
};

} // namespace placedpar::monitor
