#pragma once

#include <cstddef>
#include <optional>

namespace placedpar::identification {

/// Tells, reading by reading, a sensor that has frozen and then jumps to where what it reads has gone meanwhile, by the
/// rule of hydraulics/data/frozen_run.hpp.
class FrozenWatch {
public:
    /// All that a restart needs.
    struct State {
        std::optional<double> last;
        std::size_t equal = 0; ///< readings equal to the last, it included
        double jump = 0;       ///< from a long run to the last; 0: none

        friend bool operator==(const State&, const State&) = default;
    };

    FrozenWatch() = default;
    explicit FrozenWatch(const State& state) : state_(state) {}
    const State& state() const { return state_; }
    friend bool operator==(const FrozenWatch&, const FrozenWatch&) = default;

    /// Did it freeze, for so many readings? Told one reading after the jump.
    bool take(double reading, double least_jump, std::size_t fewest);
    /// After a gap the next reading follows none.
    void restart() { state_ = {}; }

private:
    State state_;
};

} // namespace placedpar::identification
