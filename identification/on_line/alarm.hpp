#pragma once

#include "hydraulics/data/link.hpp"
#include "identification/verdict/verdict.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::identification {

/// The faults of which the on-line diagnosis warns the excavator's operator.
enum class AlarmKind : unsigned char {
    compliance,     ///< a changed compliance, for example because of air in the oil or a softer hose
    leak,           ///< a leak from a hose or past a piston
    offset,         ///< the spool is not at the position that its sensor reads
    drift,          ///< the spool is not at the position that the servo-valve's voltage demands
    leak_or_offset, ///< either a leak, or an offset or a drift
    sensor,         ///< physically impossible readings
    branch          ///< all links that one pump feeds have the same fault, so a shared part is the cause
};

inline constexpr std::array<AlarmKind, 7> all_alarm_kinds{
    AlarmKind::compliance,     AlarmKind::leak,   AlarmKind::offset, AlarmKind::drift,
    AlarmKind::leak_or_offset, AlarmKind::sensor, AlarmKind::branch};

/// Returns the alarm for a verdict; nullopt if the verdict states no fault.
std::optional<AlarmKind> alarm_of(VerdictKind kind);
std::string_view name_of(AlarmKind);

struct Alarm {
    AlarmKind kind;
    hydraulics::LinkSet links; ///< one link, or all links of a branch
    std::string text;          ///< a sentence for the operator

    /// Compares kind and links only. The numbers in the texts of equal alarms may differ.
    friend bool operator==(const Alarm& a, const Alarm& b) { return a.kind == b.kind && a.links == b.links; }
};

/// The verdict on a link, and the sizes of deviations that count as one unit for this link.
struct LinkVerdict {
    Verdict verdict;
    WayUnits units;
};

/// Returns the alarms that follow from the verdicts, ordered by kind and link. Cross-check 2 of thesis 3.3 locates the
/// fault. If all links of a branch (the links that one pump feeds) have the same fault, the cause is a part that they
/// share: the pump, or the supply of the valves.
std::vector<Alarm> find_alarms(const hydraulics::PerLink<LinkVerdict>& verdicts);

} // namespace placedpar::identification
