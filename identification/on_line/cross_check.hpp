#pragma once

#include "hydraulics/data/link.hpp"
#include "identification/on_line/link_estimate.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::identification {

/// The compliance of a link as one population set has found it, once settled.
struct SetEstimate {
    hydraulics::LinkSet set;
    double compliance_in3_per_psi; ///< the newest settled value
    double lasting_in3_per_psi;    ///< median over the last transients
    std::size_t transients;        ///< that settled; at most kept_transients
    double time_s;                 ///< of the newest
};

/// Cross-check 1 of thesis 3.3: the same compliance, found by several population sets under different hydraulic
/// configurations.
struct LinkCheck {
    std::optional<double> baseline_in3_per_psi;
    std::vector<SetEstimate> estimates; ///< ordered by name of set, none of them stale
    bool at_lower_bound = false;        ///< is the newest estimate there?

    /// (greatest - least) / median; 0 with fewer than two estimates.
    double spread() const;
    /// The estimate with the latest time. REQUIRES: there is one.
    const SetEstimate& newest() const;
};

enum class AlarmKind : unsigned char {
    doubled,      ///< the newest settled compliance is about twice the baseline, or more
    inconsistent, ///< the sets of a link disagree
    drift,        ///< at the lower bound though excited: a spool offset, or drift of voltage against spool
    leak,         ///< one link is off in all its sets, upwards by what a leak of 5 to 10 % makes
    link_fault,   ///< one link is off in all its sets, in another way
    branch_fault  ///< all links of a branch are off in all their sets
};

inline constexpr std::array<AlarmKind, 6> all_alarm_kinds{AlarmKind::doubled,    AlarmKind::inconsistent,
                                                          AlarmKind::drift,      AlarmKind::leak,
                                                          AlarmKind::link_fault, AlarmKind::branch_fault};

std::string_view name_of(AlarmKind);

struct Alarm {
    AlarmKind kind;
    hydraulics::LinkSet links; ///< one link, or all of a branch
    std::string text;          ///< a sentence for people

    /// Alarms of the same kind and links are the same alarm, even if the figures in their texts differ.
    friend bool operator==(const Alarm& a, const Alarm& b) { return a.kind == b.kind && a.links == b.links; }
};

/// The alarms that hold, ordered by kind and link. Cross-check 2 of thesis 3.3 locates the fault: when all sets find
/// the same link off, and only that link, its hose or cylinder is at fault; when all links of a branch are off, what
/// they share is, their pump or the readings of their spools.
std::vector<Alarm> find_alarms(const hydraulics::PerLink<LinkCheck>& checks, const DiagnosisSettings& settings);

} // namespace placedpar::identification
