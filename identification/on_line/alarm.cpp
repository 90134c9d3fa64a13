#include "identification/on_line/alarm.hpp"

#include "identification/on_line/population_sets.hpp"
#include "text/counted.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar::identification {

using namespace hydraulics;

namespace {

// Pump 1 feeds bucket and boom, pump 2 swing and stick. Through the cross-over, pump 1 may also feed the stick, and
// pump 2 the boom.
constexpr std::array<LinkSet, 2> branches{LinkSet{Link::bucket, Link::boom}, LinkSet{Link::stick, Link::swing}};

/// Describes the deviation and the part to inspect.
std::string what_is_off(const LinkVerdict& link) {
    const Deviation& mean = link.verdict.deviation;
    const WayUnits& units = link.units;
    auto leak = [&] {
        const FaultSize alone = size_alone(FaultHypothesis::leak, mean);
        return fmt::format("a leak of {:.4f} in^3/(s psi) (standard error {:.4f} in^3/(s psi))",
                           units.leak_in3_per_s_psi * alone.by, units.leak_in3_per_s_psi * alone.standard_error);
    };
    auto offset = [&](double sign) {
        const FaultSize alone = size_alone(FaultHypothesis::offset, mean);
        return fmt::format("wrong by {:+.4f} in (standard error {:.4f} in)", sign * units.offset_in * alone.by,
                           units.offset_in * alone.standard_error);
    };
    switch (link.verdict.kind) {
    case VerdictKind::compliance: {
        constexpr double percent = 100 * WayUnits::compliance_share;
        const double by = mean.by[index_of(FaultHypothesis::compliance)];
        return fmt::format("the compliance has changed by {:+.0f} % (standard error {:.0f} %): {}", percent * by,
                           percent * mean.standard_error(FaultHypothesis::compliance),
                           by > 0 ? "air in the oil, or a softer hose" : "a stiffer hose, or a partly closed line");
    }
    case VerdictKind::leak: return leak() + ": check hose, cylinder and seals";
    case VerdictKind::offset: return fmt::format("the spool's reading is {}: check its sensor", offset(1));
    case VerdictKind::drift:
        return fmt::format("the spool's position for the given voltage is {}: check the servo-valve", offset(-1));
    case VerdictKind::leak_or_offset: return print_leak_or_offset(mean, units);
    default:
        if (link.verdict.unexplained > 0)
            return fmt::format("neither a sound link nor a leak, an offset or another compliance explains the readings "
                               "of its last {}: check the sensors, their units and the machine's constants",
                               counted(link.verdict.unexplained, "movement"));
        return "the readings are impossible: below vacuum, frozen, with wild single values, with a wrong sign or "
               "unit, or with a piston that moves although no oil can flow in: check the sensors";
    }
}

Alarm alarm_of(Link link, AlarmKind kind, const LinkVerdict& verdict) {
    std::string sure = kind == AlarmKind::sensor ? ""
                                                 : fmt::format("; {}, from {}", how_sure(verdict.verdict.probability),
                                                               counted(verdict.verdict.movements, "movement"));
    return {kind, {link}, fmt::format("{}: {}{}", name_of(link), what_is_off(verdict), sure)};
}

void check_branch(LinkSet branch, const PerLink<LinkVerdict>& verdicts, std::vector<Alarm>& alarms) {
    const std::vector<Link> links = links_of(branch);
    auto kind = [&](Link link) { return alarm_of(verdicts[index_of(link)].verdict.kind); };
    const auto first = kind(links.front());
    if (first && first != AlarmKind::sensor &&
        std::ranges::all_of(links, [&](Link link) { return kind(link) == first; })) {
        alarms.push_back({AlarmKind::branch, branch,
                          fmt::format("{} and {} have the same fault ({}): check the parts that they share, the pump "
                                      "and the supply of the valves",
                                      name_of(links[0]), name_of(links[1]), name_of(*first))});
        return;
    }
    for (Link link : links)
        if (auto alarm = kind(link))
            alarms.push_back(alarm_of(link, *alarm, verdicts[index_of(link)]));
}

} // namespace

std::optional<AlarmKind> alarm_of(VerdictKind kind) {
    switch (kind) {
    case VerdictKind::compliance: return AlarmKind::compliance;
    case VerdictKind::leak: return AlarmKind::leak;
    case VerdictKind::offset: return AlarmKind::offset;
    case VerdictKind::drift: return AlarmKind::drift;
    case VerdictKind::leak_or_offset: return AlarmKind::leak_or_offset;
    case VerdictKind::sensor: return AlarmKind::sensor;
    case VerdictKind::sound:
    case VerdictKind::not_enough_evidence:
    case VerdictKind::cannot_tell: break;
    }
    return std::nullopt;
}

std::string_view name_of(AlarmKind kind) {
    constexpr std::array<std::string_view, 7> names{"compliance",     "leak",   "offset", "drift",
                                                    "leak or offset", "sensor", "branch"};
    return names[static_cast<std::size_t>(kind)];
}

std::vector<Alarm> find_alarms(const PerLink<LinkVerdict>& verdicts) {
    std::vector<Alarm> alarms;
    for (LinkSet branch : branches)
        check_branch(branch, verdicts, alarms);
    std::ranges::stable_sort(alarms, {}, &Alarm::kind);
    return alarms;
}

} // namespace placedpar::identification
