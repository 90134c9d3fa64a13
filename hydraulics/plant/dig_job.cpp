#include "hydraulics/plant/dig_job.hpp"

#include <cassert>
#include <cmath>

namespace placedpar::hydraulics {

namespace {

/// Advances the position and the velocity of one coordinate by `seconds`, exactly.
void follow(double& at, double& velocity, double asked, double lag_s, double seconds) {
    const double left = std::exp(-seconds / lag_s), behind = velocity - asked;
    at += asked * seconds + behind * lag_s * (1 - left);
    velocity = asked + behind * left;
}

} // namespace

double DigJob::duration_s() const {
    double sum = 0;
    for (const JoystickMove& each : moves)
        sum += each.seconds;
    return sum;
}

TipReference::TipReference(const DigJob& job, double lag_s)
    : job_(job), lag_s_(lag_s), move_end_s_(job.moves.front().seconds), pose_(job.start) {
    assert(lag_s > 0);
}

void TipReference::advance(double seconds) {
    const TipPose& asked = job_.moves[move_].velocity;
    for (double TipPose::*each : {&TipPose::reach_in, &TipPose::height_in, &TipPose::pitch_rad, &TipPose::swing_rad})
        follow(pose_.*each, velocity_.*each, asked.*each, lag_s_, seconds);
    time_s_ += seconds;
    while (time_s_ >= move_end_s_ - 1e-9 && move_ + 1 < job_.moves.size())
        move_end_s_ += job_.moves[++move_].seconds;
}

std::optional<std::size_t> unreachable_move(const DigJob& job, const ArmLengths& lengths, double lag_s,
                                            double period_s) {
    TipReference reference(job, lag_s);
    const double end_s = job.duration_s();
    for (double time_s = 0; time_s <= end_s + period_s / 2; time_s += period_s) {
        if (!joint_angles(lengths, reference.pose()))
            return reference.move();
        reference.advance(period_s);
    }
    return std::nullopt;
}

} // namespace placedpar::hydraulics
