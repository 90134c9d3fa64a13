#pragma once

#include <cstddef>
#include <optional>

namespace placedpar::identification {

/// Detects, reading by reading, a sensor that freezes and then jumps to the present value. Uses the rule of
/// hydraulics/data/frozen_run.hpp.
class FrozenWatch {
public:
    /// Holds everything that is needed to restore the object.
    struct State {
        std::optional<double> last;
        std::size_t equal = 0; ///< number of equal readings up to the last
        double jump = 0; ///< change from a long run of equal readings to the last reading; 0: there is no such run

        friend bool operator==(const State&, const State&) = default;
    };

    FrozenWatch() = default;
    explicit FrozenWatch(const State& state) : state_(state) {}
    const State& state() const { return state_; }
    friend bool operator==(const FrozenWatch&, const FrozenWatch&) = default;

    /// Returns whether the sensor froze for at least `fewest` readings and then jumped by at least `least_jump`. The
    /// result comes one reading after the jump.
    bool take(double reading, double least_jump, std::size_t fewest);
    /// Forgets the readings after a gap.
    void restart() { state_ = {}; }

private:
    State state_;
};

} // namespace placedpar::identification
