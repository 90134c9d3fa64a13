#pragma once

#include "hydraulics/data/link.hpp"
#include "identification/verdict/verdict.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::identification {

enum class AlarmKind : unsigned char {
    compliance,     ///< air in the oil, a hose that gives
    leak,           ///< of a hose or past a piston
    offset,         ///< the spool is not where its sensor says
    drift,          ///< the spool is not where the servo-valve's voltage says
    leak_or_offset, ///< one of the two, or a leak or a drift
    sensor,         ///< readings that no machine gives
    branch          ///< all links of a branch are off in the same way: what they share
};

inline constexpr std::array<AlarmKind, 7> all_alarm_kinds{
    AlarmKind::compliance,     AlarmKind::leak,   AlarmKind::offset, AlarmKind::drift,
    AlarmKind::leak_or_offset, AlarmKind::sensor, AlarmKind::branch};

/// None of sound, and where nothing can be told.
std::optional<AlarmKind> alarm_of(VerdictKind kind);
std::string_view name_of(AlarmKind);

struct Alarm {
    AlarmKind kind;
    hydraulics::LinkSet links; ///< one link, or all of a branch
    std::string text;          ///< a sentence for people

    /// Alarms of the same kind and links are the same alarm, even if the figures in their texts differ.
    friend bool operator==(const Alarm& a, const Alarm& b) { return a.kind == b.kind && a.links == b.links; }
};

/// What is said of a link, and what its deviation is counted in.
struct LinkVerdict {
    Verdict verdict;
    WayUnits units;
};

/// The alarms that hold, ordered by kind and link. Cross-check 2 of thesis 3.3 locates the fault: where all links of a
/// branch are off in the same way, what they share is at fault, their pump or what supplies their valves.
std::vector<Alarm> find_alarms(const hydraulics::PerLink<LinkVerdict>& verdicts);

} // namespace placedpar::identification
