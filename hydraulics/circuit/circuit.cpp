#include "hydraulics/circuit/circuit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>

namespace placedpar::hydraulics {

namespace {

/// The position of a link in the main valve, whether or not the link is active.
struct ValvePosition {
    Link link;
    bool pump;
    std::optional<Link> next; ///< nullopt: the bypass leads to the tank or is blocked
    bool shut = false;
};

/// Pump 1 feeds the bucket and then the boom, pump 2 the swing and then the stick.
constexpr ValvePosition bucket_then_boom{Link::bucket, true, Link::boom}, boom_last{Link::boom, false, {}},
    swing_then_stick{Link::swing, true, Link::stick}, stick_last{Link::stick, false, {}};
/// With the cross-over valves open, flow past the stick (or the boom) continues to the last link of the other branch.
constexpr ValvePosition stick_then_boom{Link::stick, false, Link::boom},
    boom_then_stick{Link::boom, false, Link::stick};
/// In these positions a check valve shuts off the rest of the branch, because the pressure behind the check valve is
/// higher. The first link then receives the whole flow of its pump.
constexpr ValvePosition bucket_alone{Link::bucket, true, {}, true}, swing_alone{Link::swing, true, {}, true};

using ValvePositions = std::array<ValvePosition, 4>; // upstream before downstream

const ValvePositions& positions_in(Configuration configuration) {
    static constexpr std::array<ValvePositions, 5> valves{{
        {bucket_then_boom, boom_last, swing_then_stick, stick_last},
        {bucket_alone, swing_then_stick, stick_then_boom, boom_last},
        {swing_alone, bucket_then_boom, boom_then_stick, stick_last},
        {bucket_then_boom, swing_then_stick, stick_then_boom, boom_last},
        {swing_then_stick, bucket_then_boom, boom_then_stick, stick_last},
    }};
    return valves[static_cast<std::size_t>(configuration)];
}

const ValvePosition& place_of(const ValvePositions& valve, Link link) {
    return *std::ranges::find(valve, link, &ValvePosition::link);
}

/// Returns the next active link that the flow past `place` reaches.
std::optional<Link> next_active(const ValvePositions& valve, const ValvePosition& place, LinkSet active) {
    std::optional<Link> next = place.next;
    while (next && !active.contains(*next))
        next = place_of(valve, *next).next;
    return next;
}

/// Returns the first active link downstream of a pump.
std::optional<Link> fed_by(const ValvePositions& valve, const ValvePosition& first, LinkSet active) {
    return active.contains(first.link) ? first.link : next_active(valve, first, active);
}

} // namespace

char name_of(Configuration configuration) { return "abcde"[static_cast<std::size_t>(configuration)]; }

std::optional<Configuration> configuration_named(std::string_view text) {
    for (Configuration each : all_configurations)
        if (text.size() == 1 && text[0] == name_of(each))
            return each;
    return std::nullopt;
}

std::vector<LinkSet> coupled_groups(Configuration configuration) {
    switch (configuration) {
    case Configuration::a: return {{Link::bucket, Link::boom}, {Link::stick, Link::swing}};
    case Configuration::b: return {{Link::bucket}, {Link::boom, Link::stick, Link::swing}};
    case Configuration::c: return {{Link::bucket, Link::boom, Link::stick}, {Link::swing}};
    case Configuration::d:
    case Configuration::e: break;
    }
    return {LinkSet::all()};
}

Circuit circuit_of(Configuration configuration, LinkSet active) {
    assert(!active.empty());
    const ValvePositions& valve = positions_in(configuration);
    Circuit circuit;
    for (const ValvePosition& place : valve)
        if (active.contains(place.link))
            circuit.push_back({place.link, 0, place.shut ? Through::nowhere : Through::tank});
    auto junction_of = [&](Link link) {
        return static_cast<std::size_t>(std::ranges::find(circuit, link, &Junction::link) - circuit.begin());
    };
    for (Junction& junction : circuit)
        if (auto next = next_active(valve, place_of(valve, junction.link), active)) {
            junction.through = Through::junction;
            junction.next = junction_of(*next);
        }
    for (const ValvePosition& place : valve)
        if (auto first = place.pump ? fed_by(valve, place, active) : std::nullopt)
            ++circuit[junction_of(*first)].pumps;
    return circuit;
}

Circuit boom_circuit() { return circuit_of(Configuration::a, {Link::boom}); }

Circuit drain_circuit(Link link) { return {{link, 0, Through::tank, 0, Side::outlet}}; }

std::string compliance_name(const Junction& junction) {
    return fmt::format("C_{}{}", symbol_of(junction.link), junction.side == Side::inlet ? 'i' : 'o');
}

} // namespace placedpar::hydraulics
