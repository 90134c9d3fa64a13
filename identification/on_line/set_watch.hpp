#pragma once

#include "hydraulics/data/link.hpp"
#include "identification/on_line/set_problem.hpp"
#include "identification/verdict/movement.hpp"
#include "identification/verdict/verdict.hpp"

#include <optional>
#include <span>
#include <vector>

namespace placedpar::identification {

/// Checks a set of links that move together for faults. Cuts the samples into movements, and judges each link after
/// each movement.
class SetWatch {
public:
    /// Holds everything that is needed to restore the object. Links are in the order of links_of()
    /// (population_sets.hpp).
    struct State {
        Movement::State movement;
        std::vector<hydraulics::AreasFrom> valves; ///< sources of the newest sample's areas
        std::vector<LinkJudge::State> judges;
        std::vector<std::size_t> moving_shut; ///< number of successive samples, up to the newest, in which the piston
                                              ///< moves although no oil could flow in

        friend bool operator==(const State&, const State&) = default;
    };

    static State first_state(hydraulics::LinkSet links);
    SetWatch(const hydraulics::Sampling& sampling, State state) : sampling_(sampling), state_(std::move(state)) {}
    const State& state() const { return state_; }

    /// The deviation of each link in the movement that has ended, in the order of links_of(); nullopt if no movement
    /// has ended.
    using Judged = std::optional<std::vector<Deviation>>;

    /// Adds a sample. `health_in3_per_psi` holds the healthy compliances of the links. REQUIRES: the problem has the
    /// links of this set, and each span has one entry per link.
    Judged take(const SetProblem& problem, const SetSample& sample, std::span<const hydraulics::AreasFrom> valves,
                std::span<const double> health_in3_per_psi);
    /// Records an impossible reading for each link whose piston has moved for half a second while no oil could flow in:
    /// the valve reads shut, or the pressure reads higher than the supply's. Returns whether a link has such a reading.
    /// Call this function before take(), with the same sample. REQUIRES: as take().
    bool note_moving_shut(const SetProblem& problem, const SetSample& sample,
                          std::span<const double> health_in3_per_psi);
    /// Ends and judges the present movement after a gap in the samples or a change of configuration.
    Judged end_movement(const SetProblem& problem, std::span<const double> health_in3_per_psi);
    /// Records an impossible reading of the link at `position`.
    void note_impossible(std::size_t position);

private:
    Judged judge_movement(const SetProblem& problem, std::span<const double> health_in3_per_psi);
    void note_senseless(const SetProblem& problem, const MovementSamples& movement,
                        std::span<const Deviation> deviations);

    hydraulics::Sampling sampling_;
    State state_;
};

} // namespace placedpar::identification
