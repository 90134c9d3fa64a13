#include "monitor/service/places.hpp"

#include <algorithm>
#include <tuple>

namespace placedpar::monitor {

std::optional<std::size_t> gives_way(std::span<const Occupant> places, const std::string& peer, bool preferred) {
    std::map<std::string, std::size_t> of_peer;
    for (const Occupant& place : places)
        of_peer[place.peer] += !place.kept;
    const std::size_t own = of_peer[peer];
    auto may_go = [&](const Occupant& p) {
        return !p.kept && (preferred || of_peer[p.peer] > own + 1 || (p.idle && p.peer == peer));
    };
    auto comes_before = [&](const Occupant& x, const Occupant& y) { // the peer with most places comes first
        return std::tuple(of_peer[y.peer], !x.idle, x.samples, x.heard) <
               std::tuple(of_peer[x.peer], !y.idle, y.samples, y.heard);
    };
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < places.size(); ++i)
        if (may_go(places[i]) && (!found || comes_before(places[i], places[*found])))
            found = i;
    return found;
}

void MachinePlaces::keep(Machine& machine, bool kept) {
    if (machine.kept == kept)
        return;
    machine.kept = kept;
    kept ? ++kept_ : --kept_;
    kept ? ++peers_[machine.peer].kept : --peers_[machine.peer].kept;
}

bool MachinePlaces::find_kept_place() {
    if (kept_ < most_kept(limits_.machines))
        return true;
    Machine* least = nullptr;
    for (auto& [name, each] : machines_)
        if (each.kept && each.samples < limits_.known_samples && (!least || each.samples < least->samples))
            least = &each;
    if (least)
        keep(*least, false);
    return least != nullptr;
}

void MachinePlaces::restored(const std::string& machine, std::uint64_t samples, Clock::time_point now) {
    introduced(machine, "", now);
    Machine& it = machines_.at(machine);
    it.samples = samples;
    it.begun = now;
    keep(it, samples > 0 && kept_ < most_kept(limits_.machines));
}

void MachinePlaces::introduced(const std::string& machine, const std::string& peer, Clock::time_point now) {
    forgotten(machine);
    machines_[machine] = {{peer, false, false, 0, now}, std::nullopt};
    ++peers_[peer].machines;
}

void MachinePlaces::forgotten(const std::string& machine) {
    auto found = machines_.find(machine);
    if (found == machines_.end())
        return;
    keep(found->second, false);
    if (auto share = peers_.find(found->second.peer); --share->second.machines == 0)
        peers_.erase(share);
    machines_.erase(found);
}

bool MachinePlaces::heard(const std::string& machine, std::uint64_t samples, Clock::time_point now) {
    Machine& it = machines_.at(machine);
    const bool more = samples > it.samples;
    it.samples = samples;
    it.heard = now;
    if (samples == 0) {
        keep(it, false);
        it.begun.reset();
    } else if (!it.begun)
        it.begun = now;
    if (!more || it.kept || samples < limits_.known_samples ||
        std::chrono::duration<double>(now - *it.begun).count() < limits_.known_s ||
        (!it.peer.empty() && peers_.at(it.peer).kept >= most_kept(limits_.machines_per_peer)) || !find_kept_place())
        return false;
    keep(it, true);
    return true;
}

std::size_t MachinePlaces::introduced_by(const std::string& peer) const {
    auto found = peers_.find(peer);
    return found == peers_.end() ? 0 : found->second.machines;
}

std::vector<std::string> MachinePlaces::unused_since(Clock::time_point then) const {
    std::vector<std::string> unused;
    for (const auto& [name, machine] : machines_)
        if (machine.samples == 0 && machine.heard < then)
            unused.push_back(name);
    return unused;
}

std::optional<std::string> MachinePlaces::gives_way(const std::string& peer, bool only_own,
                                                    const std::function<bool(const std::string&)>& idle) const {
    std::vector<std::string> names;
    std::vector<Occupant> places;
    for (const auto& [name, machine] : machines_)
        if (!only_own || machine.peer == peer) {
            names.push_back(name);
            places.push_back(machine);
            places.back().idle = idle(name);
        }
    auto found = monitor::gives_way(places, peer, false);
    return found ? std::optional(names[*found]) : std::nullopt;
}

} // namespace placedpar::monitor
