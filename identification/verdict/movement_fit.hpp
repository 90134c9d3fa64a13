#pragma once

#include "hydraulics/circuit/circuit.hpp"
#include "hydraulics/circuit/flow_constants.hpp"
#include "hydraulics/circuit/link_calibration.hpp"
#include "identification/verdict/deviation.hpp"
#include "identification/verdict/movement.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace placedpar::identification {

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
