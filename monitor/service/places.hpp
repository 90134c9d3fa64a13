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

/// A machine (excavator under diagnosis) or a connection. Both are limited in number, that is, each occupies a place.
struct Occupant {
    std::string peer;  ///< owner: the computer or user from which the occupant comes (Caller::peer); "": unknown
    bool kept = false; ///< no newcomer takes the place, because the occupant is, or serves, a known machine
    bool idle = false; ///< not in use, so that its owner may use the place for another occupant
    std::uint64_t samples = 0;                   ///< number of accepted samples
    std::chrono::steady_clock::time_point heard; ///< time of the last message
};

/// Returns how many of `places` may be kept, that is, be safe from newcomers. At least an eighth of the places is not
/// kept.
constexpr std::size_t most_kept(std::size_t places) { return places - (places + 7) / 8; }

/// Returns which occupant must leave for a newcomer of `peer` when all places are taken, or nullopt if the newcomer is
/// refused. Places that are not kept are shared evenly among peers. An occupant of the peer with most places leaves, if
/// that peer then still has at least as many places as the newcomer's peer. Otherwise an idle occupant of the
/// newcomer's own peer leaves. Among the occupants of a peer, idle occupants leave first, then occupants with the
/// fewest samples, then those silent for the longest time. With `preferred`, the newcomer is a known machine and may
/// take any place that is not kept.
std::optional<std::size_t> gives_way(std::span<const Occupant> places, const std::string& peer, bool preferred);

/// The places of machines. A flood of invented machines must not drive out real machines. Therefore a machine that has
/// sent many samples over some time becomes known, and newcomers cannot take its place. The number of such places is
/// limited (most_kept()), both in total and for the machine's peer. REQUIRES: every machine named in a call has been
/// restored or introduced, and not forgotten since.
class MachinePlaces {
public:
    using Clock = std::chrono::steady_clock;

    explicit MachinePlaces(const ServiceLimits& limits) : limits_(limits) {}

    /// Adds a machine from the state file. The machine is known if it has any samples. While it has fewer than
    /// `known_samples` samples, another machine that becomes known may take over this status. REQUIRES: machines are
    /// restored in order of falling `samples`.
    void restored(const std::string& machine, std::uint64_t samples, Clock::time_point now);
    void introduced(const std::string& machine, const std::string& peer, Clock::time_point now);
    void forgotten(const std::string& machine);
    /// Records that the machine now has `samples` samples; 0 means that all its data was deleted. Returns true if the
    /// machine becomes known by this call.
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
    /// Returns whether one more machine may keep its place. If no place is left, the known machine with the fewest
    /// samples stops being known, provided that it has fewer than `known_samples` samples.
    bool find_kept_place();

    const ServiceLimits& limits_;
    std::map<std::string, Machine> machines_;
    std::map<std::string, Share> peers_;
    std::size_t kept_ = 0;
};

} // namespace placedpar::monitor
