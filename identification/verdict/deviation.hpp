#pragma once

#include "hydraulics/circuit/circuit.hpp"
#include "hydraulics/circuit/flow_constants.hpp"
#include "hydraulics/circuit/link_calibration.hpp"
#include "identification/verdict/movement.hpp"

#include <Eigen/Dense>

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace placedpar::identification {

/// In what way a link can be off. A compliance that is too great or small misses flow in step with the slope of the
/// pressure, up while it rises and down while it falls; a leak in step with the pressure, also at rest after the valve
/// has shut; an offset of the spool, or a drift of voltage against spool, only while oil flows through the valve. A
/// leak before the movement is a size of its own, since a leak can begin when the valve opens.
enum class Way : unsigned char { compliance, leak, offset, leak_before };

inline constexpr std::array<Way, 4> all_ways{Way::compliance, Way::leak, Way::offset, Way::leak_before};

/// A size of each way, in the order of all_ways; and what two of them have in common. Not aligned, since the alignment
/// of Eigen's own would depend on the flags that this header is compiled with.
using OfWays = Eigen::Matrix<double, 4, 1, Eigen::DontAlign>;
using OfTwoWays = Eigen::Matrix<double, 4, 4, Eigen::DontAlign>;

inline constexpr Eigen::Index index_of(Way way) { return static_cast<Eigen::Index>(way); }

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
    OfWays by = OfWays::Zero();
    OfTwoWays covariance = OfTwoWays::Zero();

    double standard_error(Way) const;
    /// The inverse of the covariance, what does not repeat from movement to movement (repeats_within) added to it.
    OfTwoWays information() const;
    /// What the deviation is if a leak is the same before the movement and during it. Flow alone hardly tells a leak
    /// from an offset; then the rest before the movement does.
    Deviation with_steady_leak() const;
    friend bool operator==(const Deviation&, const Deviation&) = default;
};

/// What is known of a link before a movement.
struct LinkInHealth {
    double compliance_in3_per_psi;
    /// Areas that are read themselves have no offset.
    hydraulics::AreasFrom areas = hydraulics::AreasFrom::spool;
};

/// Fewer samples of a movement say nothing (ours).
inline constexpr std::size_t fewest_moving = 12;

/// What a movement says of the links of a circuit, in the order of its junctions: generalised least squares of the flow
/// that the equations miss (3.5 to 3.7, 3.10, 3.11; signed) on compliance, leak and offset of every link, and of
/// A v + C dP/dt + k_l P = 0 at rest, whatever the spool reads, which tells the leak there: that before the movement,
/// or that during it when the rest follows. A rest after counts only with one before: without it, as at the end of a
/// long movement, nothing but the closing of the valve would tell the compliance.
///
/// The errors' covariance is what the noise of the readings makes of the missed flows, of all junctions together: of
/// pressures, angles and valves, each as its own fourth differences show it, through the equations and through the
/// 5-point slopes; scaled by what is left. The noise of the slopes would make compliances too small; it is taken out of
/// the normal equations (W. Fuller, Measurement Error Models, 1987). None with fewer than fewest_moving moving samples,
/// or where the slopes are hardly more than noise.
std::optional<std::vector<Deviation>> deviations(const hydraulics::Circuit& circuit,
                                                 const hydraulics::FlowConstants& flow,
                                                 std::span<const LinkInHealth> links, const MovementSamples& movement);

} // namespace placedpar::identification
