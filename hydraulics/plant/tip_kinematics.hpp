#pragma once

#include "hydraulics/data/link.hpp"

#include <optional>

namespace placedpar::hydraulics {

class Parameters; // hydraulics/data/parameters.hpp

/// The lengths of the arm's links, joint to joint or joint to tip; all > 0.
struct ArmLengths {
    double boom_in, stick_in, bucket_in;
};

/// Reads the parameters arm.*.
ArmLengths arm_lengths(const Parameters& parameters);

/// The position of the bucket's tip and the direction of the bucket, or their rates per second.
struct TipPose {
    double reach_in;  ///< horizontal distance from the boom's foot
    double height_in; ///< height above the boom's foot
    double pitch_rad; ///< angle of the bucket above the horizontal
    double swing_rad;
};

/// The angles of the joints in rad. The boom's angle is measured upwards from the horizontal. The stick's angle is its
/// bend from the boom's direction, 0 to pi; the bucket's angle is its bend from the stick's direction. Both bends grow
/// as the arm folds inwards and down.
using JointAngles = PerLink<double>;

TipPose tip_pose(const ArmLengths&, const JointAngles&);

/// Returns the angles for a pose, with the stick's bend from 0 to pi. Returns nullopt if boom and stick do not reach
/// the pose. Also returns nullopt if the stick's bend is within `margin_rad` of 0 or pi, because the joints' rates
/// there can become infinite.
std::optional<JointAngles> joint_angles(const ArmLengths&, const TipPose&, double margin_rad = 0.05);

/// Returns the rates of the joints that move the tip at this velocity (resolved motion, thesis 2.1). REQUIRES: the
/// stick's bend is neither 0 nor pi.
JointAngles joint_rates(const ArmLengths&, const JointAngles&, const TipPose& velocity);

/// Returns the torque with which a force on the tip acts on each joint, positive in the direction of growing angles
/// (the transposed Jacobian); 0 at the swing.
PerLink<double> joint_torques_lbf_in(const ArmLengths&, const JointAngles&, double outward_lbf, double upward_lbf);

} // namespace placedpar::hydraulics
