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

/// A machine or a connection, of which there may be only so many.
struct Occupant {
    std::string peer;                            ///< whose it is, as Caller::peer; "": unknown
    bool kept = false;                           ///< no newcomer takes it: a known machine's
    bool idle = false;                           ///< not in use, so that its own peer may have it for another
    std::uint64_t samples = 0;                   ///< that were accepted
    std::chrono::steady_clock::time_point heard; ///< last
};

/// So many of these places may be kept: the last eighth is always there for newcomers.
constexpr std::size_t most_kept(std::size_t places) { return places - (places + 7) / 8; }

/// The place that a newcomer of this peer takes when all are taken; none: the newcomer is refused. Places that are not
/// kept are shared alike by the peers: one of the peer with most of them goes, if that peer has at least as many left
/// then as the newcomer's, or an idle one of the newcomer's own. Of one peer first what is idle goes, then what has
/// fewest samples, then what was silent longest. `preferred`: it is a known machine, which takes any that is not kept.
std::optional<std::size_t> gives_way(std::span<const Occupant> places, const std::string& peer, bool preferred);

/// The places of machines. A machine is known, and its place kept, when it has sent many samples over a while, and the
/// part of places that may be kept, of all and of its peer's, is not used up. REQUIRES: every machine that is named has
/// been restored or introduced, and not forgotten since.
class MachinePlaces {
public:
    using Clock = std::chrono::steady_clock;

    explicit MachinePlaces(const ServiceLimits& limits) : limits_(limits) {}

    /// From the state file: with any sample it is known, but makes way for a machine that becomes known, as long as it
    /// has too few itself. REQUIRES: those with most samples come first.
    void restored(const std::string& machine, std::uint64_t samples, Clock::time_point now);
    void introduced(const std::string& machine, const std::string& peer, Clock::time_point now);
    void forgotten(const std::string& machine);
    /// It has so many samples by now; 0: it began anew. True when this makes it known.
    bool heard(const std::string& machine, std::uint64_t samples, Clock::time_point now);

    bool known(const std::string& machine) const { return machines_.contains(machine) && machines_.at(machine).kept; }
    std::size_t introduced_by(const std::string& peer) const;
    /// Returns those that have sent no sample and have been silent since then.
    std::vector<std::string> unused_since(Clock::time_point then) const;
    /// The machine to be forgotten for a new one of this peer; `only_own`: of those that it has introduced.
    std::optional<std::string> gives_way(const std::string& peer, bool only_own,
                                         const std::function<bool(const std::string&)>& idle) const;

private:
    struct Machine : Occupant {
        std::optional<Clock::time_point> begun; ///< when the first sample came
    };
    struct Share {
        std::size_t machines = 0, kept = 0;
    };

    void keep(Machine& machine, bool kept);
    /// Finds a place that one more machine may keep, if need be by giving up that of the machine with the fewest
    /// samples, fewer than known_samples. Returns false where there is none.
    bool find_kept_place();

    const ServiceLimits& limits_;
    std::map<std::string, Machine> machines_;
    std::map<std::string, Share> peers_;
    std::size_t kept_ = 0;
};

} // namespace placedpar::monitor
