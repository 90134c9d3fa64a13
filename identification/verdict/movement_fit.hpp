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

/// What a healthy link is like. The deviations of a link are measured from this state.
struct LinkInHealth {
    double compliance_in3_per_psi;
    /// The source of the link's areas. Areas that are measured directly have no offset.
    hydraulics::AreasFrom areas = hydraulics::AreasFrom::spool;
};

/// Movements with fewer samples are not evaluated (our choice).
inline constexpr std::size_t fewest_moving = 12;

/// What the samples of one movement say about the links of a circuit.
struct MovementFit {
    std::vector<Deviation> links; ///< how far each link deviates from a healthy link, in the order of the junctions
    /// The factor by which the variance of what the deviations leave unexplained exceeds the variance of the noise. The
    /// standard errors of the deviations have been enlarged by its square root.
    double misfit = 1;

    friend bool operator==(const MovementFit&, const MovementFit&) = default;
};

/// Fits the deviations of each link to one movement. The method is generalised least squares. For the samples in
/// motion, it explains the missing flow, the error of the flow balances (equations 3.5 to 3.7, 3.10, 3.11; signed), by
/// compliance, leak and offset of every link. For the samples at rest, it uses A v + C dP/dt + k_l P = 0, which is
/// independent of the spool. The rest before the movement determines the leak before the movement. The rest after the
/// movement determines the leak during the movement, but is used only if there is also a rest before. Otherwise, as at
/// the end of a long movement, only the closing of the valve would determine the compliance.
///
/// The covariance of the errors follows from the noise of pressures, angles and valves at all junctions. Each noise is
/// estimated from the fourth differences of its readings, and propagated through the equations and through the slopes
/// of lines fitted to 5 readings. The residuals scale the result. The noise of the slopes would make compliances too
/// small, so it is removed from the normal equations (W. Fuller, Measurement Error Models, 1987). Returns nullopt if
/// there are fewer than `fewest_moving` samples in motion, or if the slopes are hardly more than noise.
std::optional<MovementFit> fit_movement(const hydraulics::Circuit& circuit, const hydraulics::FlowConstants& flow,
                                        std::span<const LinkInHealth> links, const MovementSamples& movement);

} // namespace placedpar::identification
