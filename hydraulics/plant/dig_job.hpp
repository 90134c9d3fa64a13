#pragma once

#include "hydraulics/plant/tip_kinematics.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace placedpar::hydraulics {

/// A time during which the joysticks are held. The joysticks demand a velocity of the bucket's tip (2.1), and the soil
/// opposes the motion with a force.
struct JoystickMove {
    double seconds;       ///< > 0
    TipPose velocity;     ///< change of the pose per second
    double soil_lbf;      ///< >= 0
    std::size_t line = 0; ///< line of the move in the job's file; 0: no file
};

struct DigJob {
    std::string name;  ///< name of the job's file
    std::string about; ///< description; may be empty
    TipPose start;
    std::vector<JoystickMove> moves;

    double duration_s() const;
};

/// The reference trajectory of the tip. The velocity approaches the velocity that the joysticks demand; the difference
/// falls like exp(-t / `lag_s`). The pose is the exact integral of the velocity.
class TipReference {
public:
    /// REQUIRES: the job has moves and outlives this object; lag_s > 0.
    TipReference(const DigJob& job, double lag_s);

    const TipPose& pose() const { return pose_; }
    const TipPose& velocity() const { return velocity_; } ///< per second
    /// Returns the index of the move in progress; after the end of the job, the index of the last move.
    std::size_t move() const { return move_; }
    const JoystickMove& current() const { return job_.moves[move_]; }
    /// Advances by `seconds`, during which the joysticks stay as they are at the beginning.
    void advance(double seconds);

private:
    const DigJob& job_;
    double lag_s_, time_s_ = 0, move_end_s_;
    std::size_t move_ = 0;
    TipPose pose_, velocity_{};
};

/// Returns the index of the first move in which the reference leaves the arm's reach, checked every `period_s`; nullopt
/// if there is none.
std::optional<std::size_t> unreachable_move(const DigJob&, const ArmLengths&, double lag_s, double period_s);

} // namespace placedpar::hydraulics
