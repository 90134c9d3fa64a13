#include "hydraulics/plant/tip_kinematics.hpp"

#include "hydraulics/data/parameters.hpp"

#include <cmath>
#include <numbers>

namespace placedpar::hydraulics {

namespace {

constexpr std::size_t bucket = index_of(Link::bucket), boom = index_of(Link::boom), stick = index_of(Link::stick),
                      swing = index_of(Link::swing);

struct InPlane {
    double out, up;
};

InPlane along(double length_in, double angle_rad) {
    return {length_in * std::cos(angle_rad), length_in * std::sin(angle_rad)};
}

/// The three links as vectors, each from its joint to the next joint or to the tip.
struct Arm {
    InPlane boom, stick, bucket;
};

Arm arm_at(const ArmLengths& lengths, const JointAngles& angles) {
    const double stick_rad = angles[boom] - angles[stick];
    return {along(lengths.boom_in, angles[boom]), along(lengths.stick_in, stick_rad),
            along(lengths.bucket_in, stick_rad - angles[bucket])};
}

} // namespace

ArmLengths arm_lengths(const Parameters& parameters) {
    return {parameters["arm.boom_length"], parameters["arm.stick_length"], parameters["arm.bucket_length"]};
}

TipPose tip_pose(const ArmLengths& lengths, const JointAngles& angles) {
    const Arm arm = arm_at(lengths, angles);
    return {arm.boom.out + arm.stick.out + arm.bucket.out, arm.boom.up + arm.stick.up + arm.bucket.up,
            angles[boom] - angles[stick] - angles[bucket], angles[swing]};
}

std::optional<JointAngles> joint_angles(const ArmLengths& lengths, const TipPose& pose, double margin_rad) {
    const InPlane bucket_at = along(lengths.bucket_in, pose.pitch_rad);
    // The position of the bucket's joint.
    const double out = pose.reach_in - bucket_at.out, up = pose.height_in - bucket_at.up;
    const double a = lengths.boom_in, b = lengths.stick_in;
    const double cosine = (out * out + up * up - a * a - b * b) / (2 * a * b);
    if (!(std::abs(cosine) <= 1))
        return std::nullopt;
    JointAngles angles{};
    angles[stick] = std::acos(cosine);
    if (angles[stick] < margin_rad || angles[stick] > std::numbers::pi - margin_rad)
        return std::nullopt;
    angles[boom] = std::atan2(up, out) + std::atan2(b * std::sin(angles[stick]), a + b * cosine);
    angles[bucket] = angles[boom] - angles[stick] - pose.pitch_rad;
    angles[swing] = pose.swing_rad;
    return angles;
}

JointAngles joint_rates(const ArmLengths& lengths, const JointAngles& angles, const TipPose& velocity) {
    const Arm arm = arm_at(lengths, angles);
    // The velocity of the bucket's joint is the tip's velocity minus the part due to the bucket's rotation.
    const double out = velocity.reach_in + arm.bucket.up * velocity.pitch_rad;
    const double up = velocity.height_in - arm.bucket.out * velocity.pitch_rad;
    const double x = arm.boom.out + arm.stick.out, y = arm.boom.up + arm.stick.up, square = x * x + y * y;
    const double a = lengths.boom_in, b = lengths.stick_in;
    JointAngles rates{};
    rates[stick] = -(x * out + y * up) / (a * b * std::sin(angles[stick]));
    rates[boom] = (x * up - y * out) / square + rates[stick] * b * (b + a * std::cos(angles[stick])) / square;
    rates[bucket] = rates[boom] - rates[stick] - velocity.pitch_rad;
    rates[swing] = velocity.swing_rad;
    return rates;
}

PerLink<double> joint_torques_lbf_in(const ArmLengths& lengths, const JointAngles& angles, double outward_lbf,
                                     double upward_lbf) {
    const Arm arm = arm_at(lengths, angles);
    const double x2 = arm.bucket.out, y2 = arm.bucket.up, x1 = x2 + arm.stick.out, y1 = y2 + arm.stick.up;
    const double x = x1 + arm.boom.out, y = y1 + arm.boom.up;
    PerLink<double> torques{};
    torques[boom] = -y * outward_lbf + x * upward_lbf;
    torques[stick] = y1 * outward_lbf - x1 * upward_lbf;
    torques[bucket] = y2 * outward_lbf - x2 * upward_lbf;
    return torques;
}

} // namespace placedpar::hydraulics
