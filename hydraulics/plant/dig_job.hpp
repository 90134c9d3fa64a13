#pragma once

#include "hydraulics/plant/tip_kinematics.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace placedpar::hydraulics {

/// A part of a job, during which the operator holds the joysticks still. The joysticks demand a velocity of the
/// bucket's tip (thesis 2.1), and the soil opposes the motion with a force.
struct JoystickMove {
    double seconds;       ///< > 0
    TipPose velocity;     ///< change of the pose per second
    double soil_lbf;      ///< >= 0
    std::size_t line = 0; ///< line of the move in the job's file; 0: no file
};

/// A digging job of a simulated excavator: the moves of the joysticks, one after the other.
struct DigJob {
    std::string name;  ///< name of the job's file
    std::string about; ///< description; may be empty
    TipPose start;
    std::vector<JoystickMove> moves;

    double duration_s() const;
};

/// The trajectory of the bucket's tip that the controller makes from the joysticks' moves. The velocity approaches the
/// velocity that the joysticks demand: the difference falls like exp(-t / `lag_s`). The pose is the exact integral of
/// the velocity.
class TipReference {
public:
    /// REQUIRES: the job has moves and outlives this object; lag_s > 0.
    TipReference(const DigJob& job, double lag_s);

    const TipPose& pose() const { return pose_; }
    const TipPose& velocity() const { return velocity_; } ///< per second
    /// Returns the index of the move in progress; after the end of the job, the index of the last move.
    std::size_t move() const { return move_; }
    const JoystickMove& current() const { return job_.moves[move_]; }
    /// Advances by `seconds`, with the joysticks held as at the beginning of this time.
    void advance(double seconds);

private:
    const DigJob& job_;
    double lag_s_, time_s_ = 0, move_end_s_;
    std::size_t move_ = 0;
    TipPose pose_, velocity_{};
};

/// Returns the index of the first move in which the trajectory leaves the arm's reach, checked every `period_s`.
/// Returns nullopt if the arm reaches the whole trajectory.
std::optional<std::size_t> unreachable_move(const DigJob&, const ArmLengths&, double lag_s, double period_s);

} // namespace placedpar::hydraulics
