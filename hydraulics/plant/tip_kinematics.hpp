#pragma once

#include "hydraulics/data/link.hpp"

#include <optional>

namespace placedpar::hydraulics {

class Parameters; // hydraulics/data/parameters.hpp

/// The lengths of the arm's links, joint to joint or joint to tip; all > 0.
struct ArmLengths {
    double boom_in, stick_in, bucket_in;
};

/// Reads the rows arm.*.
ArmLengths arm_lengths(const Parameters& parameters);

/// Where the bucket's tip is, and which way the bucket points. The same four numbers also serve as velocities, per
/// second.
struct TipPose {
    double reach_in;  ///< from the boom's foot, horizontally
    double height_in; ///< above the boom's foot
    double pitch_rad; ///< of the bucket, above the horizontal
    double swing_rad;
};

/// The angles of the joints in rad. The boom's is above the horizontal. The stick's is its bend from the boom's
/// direction, 0 to pi, and the bucket's its bend from the stick's direction; both grow as the arm folds inwards and
/// down, which is the direction in which the pump moves them.
using JointAngles = PerLink<double>;

/// Returns the pose of the tip.
TipPose tip_pose(const ArmLengths&, const JointAngles&);

/// Returns the angles that give this pose, with the stick's bend from 0 to pi; nullopt if boom and stick do not reach
/// it, or only stretched or folded to within `margin_rad`, where rates have no bound.
std::optional<JointAngles> joint_angles(const ArmLengths&, const TipPose&, double margin_rad = 0.05);

/// Returns the rates of the joints that move the tip at this velocity (resolved motion, 2.1). REQUIRES: the stick's
/// bend is neither 0 nor pi.
JointAngles joint_rates(const ArmLengths&, const JointAngles&, const TipPose& velocity);

/// Returns the torque with which a force on the tip acts on each joint, positive in the direction of growing angles
/// (the transposed Jacobian); 0 at the swing.
PerLink<double> joint_torques_lbf_in(const ArmLengths&, const JointAngles&, double outward_lbf, double upward_lbf);

} // namespace placedpar::hydraulics
