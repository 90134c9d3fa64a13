#pragma once

#include "hydraulics/plant/tip_kinematics.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace placedpar::hydraulics {

/// The joysticks for a while: the velocity that the operator asks of the bucket's tip (2.1), and the force with which
/// the soil opposes it.
struct JoystickMove {
    double seconds;       ///< > 0
    TipPose velocity;     ///< per second
    double soil_lbf;      ///< >= 0
    std::size_t line = 0; ///< in the job's file; 0: none
};

/// What the operator does.
struct DigJob {
    std::string name;  ///< of its file
    std::string about; ///< perhaps empty
    TipPose start;
    std::vector<JoystickMove> moves;

    double duration_s() const;
};

/// The reference trajectory of the tip: its velocity approaches that of the joysticks like exp(-t / lag), and its pose
/// is the exact integral.
class TipReference {
public:
    /// REQUIRES: the job has moves and outlives this object; lag_s > 0.
    TipReference(const DigJob& job, double lag_s);

    const TipPose& pose() const { return pose_; }
    const TipPose& velocity() const { return velocity_; } ///< per second
    /// Returns the index of the move in progress; after the last move, that of the last.
    std::size_t move() const { return move_; }
    const JoystickMove& current() const { return job_.moves[move_]; }
    /// Advances by a time in which the joysticks are held as at its beginning.
    void advance(double seconds);

private:
    const DigJob& job_;
    double lag_s_, time_s_ = 0, move_end_s_;
    std::size_t move_ = 0;
    TipPose pose_, velocity_{};
};

/// Returns the first move in which the reference, looked at every `period_s`, leaves the arm's reach; nullopt if it
/// never does.
std::optional<std::size_t> unreachable_move(const DigJob&, const ArmLengths&, double lag_s, double period_s);

} // namespace placedpar::hydraulics
