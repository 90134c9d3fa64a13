#pragma once

#include <array>
#include <cstddef>

namespace placedpar::identification {

/// In what way a link can be off. A compliance that is too great or small misses flow in step with the slope of the
/// pressure, up while it rises and down while it falls; a leak in step with the pressure, also at rest after the valve
/// has shut; an offset of the spool, or a drift of voltage against spool, only while oil flows through the valve. A
/// leak before the movement is a size of its own, since a leak can begin when the valve opens.
enum class Way : unsigned char { compliance, leak, offset, leak_before };

inline constexpr std::array<Way, 4> all_ways{Way::compliance, Way::leak, Way::offset, Way::leak_before};

/// A size of each way, in the order of all_ways; and what two of them have in common, a matrix column by column. What
/// computes with them includes way_matrices.hpp.
using OfWays = std::array<double, all_ways.size()>;
using OfTwoWays = std::array<double, all_ways.size() * all_ways.size()>;

inline constexpr std::size_t index_of(Way way) { return static_cast<std::size_t>(way); }

/// How much of each way is called one unit: what a verdict is asked to find (ours).
struct WayUnits {
    double compliance_in3_per_psi;      ///< 20 % of the link's compliance
    double leak_in3_per_s_psi = 0.0014; ///< a leak of 5 %: of the steady 50 in^3/s at 1750 psi
    double offset_in = 0.005;           ///< by which the spool's reading is too high
    static constexpr double compliance_share = 0.2;

    /// REQUIRES: compliance above 0.
    static WayUnits of(double compliance_in3_per_psi) { return {compliance_share * compliance_in3_per_psi}; }
};

/// What the equations themselves are off by from one movement to the next, in units, however long it is; ours. An
/// offset repeats better: tuned on the machines of seeds 4001 to 5040, so that leaks that begin with a movement are
/// found.
inline constexpr double repeats_within = 0.15, offset_repeats_within = 0.1375;

/// By how much a link is off in each way, in units of WayUnits, by one movement or by several.
struct Deviation {
    OfWays by{};
    OfTwoWays covariance{};

    double standard_error(Way) const;
    /// The inverse of the covariance, what does not repeat from movement to movement (repeats_within) added to it.
    OfTwoWays information() const;
    /// What the deviation is if a leak is the same before the movement and during it. Flow alone hardly tells a leak
    /// from an offset; then the rest before the movement does.
    Deviation with_steady_leak() const;
    friend bool operator==(const Deviation&, const Deviation&) = default;
};

} // namespace placedpar::identification
