#pragma once

#include <cstddef>
#include <optional>

namespace placedpar::identification {

/// Detects a faulty sensor that repeats one reading for a while and then jumps to the true value. Uses the rule of
/// hydraulics/data/frozen_run.hpp, but takes one reading after the other.
class FrozenWatch {
public:
    /// Holds everything that is needed to restore the object.
    struct State {
        std::optional<double> last;
        std::size_t equal = 0; ///< number of equal readings up to the last
        double jump = 0;       ///< change from a long run of equal readings to the last reading; 0 without such a run

        friend bool operator==(const State&, const State&) = default;
    };

    FrozenWatch() = default;
    explicit FrozenWatch(const State& state) : state_(state) {}
    const State& state() const { return state_; }
    friend bool operator==(const FrozenWatch&, const FrozenWatch&) = default;

    /// Adds a reading. Returns whether the sensor gave at least `fewest` equal readings and then jumped by at least
    /// `least_jump`. The result is true one reading after the jump, because the step after the jump must be known.
    bool take(double reading, double least_jump, std::size_t fewest);
    /// Forgets the readings after a gap.
    void restart() { state_ = {}; }

private:
    State state_;
};

} // namespace placedpar::identification
