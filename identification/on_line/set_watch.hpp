#pragma once

#include "hydraulics/data/link.hpp"
#include "identification/on_line/set_problem.hpp"
#include "identification/verdict/movement.hpp"
#include "identification/verdict/verdict.hpp"

#include <optional>
#include <span>
#include <vector>

namespace placedpar::identification {

/// Watches the links of a population set for faults, movement by movement.
class SetWatch {
public:
    /// All that a restart needs. Links in the order of links_of(set).
    struct State {
        Movement::State movement;
        std::vector<hydraulics::AreasFrom> valves; ///< of the newest sample
        std::vector<LinkJudge::State> judges;
        std::vector<std::size_t>
            moving_shut; ///< samples, up to the newest, in which the valve is shut and oil flows in

        friend bool operator==(const State&, const State&) = default;
    };

    static State first_state(hydraulics::LinkSet links);
    SetWatch(const hydraulics::Sampling& sampling, State state) : sampling_(sampling), state_(std::move(state)) {}
    const State& state() const { return state_; }

    /// By how much each link is off by a movement that is over, in the order of links_of(); none where there is none.
    using Judged = std::optional<std::vector<Deviation>>;

    /// One sample more. `health_in3_per_psi` are the links' compliances in health.
    /// REQUIRES: the problem is one of this set's links; as many entries as links.
    Judged take(const SetProblem& problem, const SetSample& sample, std::span<const hydraulics::AreasFrom> valves,
                std::span<const double> health_in3_per_psi);
    /// The same sample: has a piston been driven for half a second by a valve that reads shut? That is noted then.
    bool note_moving_shut(const SetSample& sample, std::span<const double> health_in3_per_psi);
    /// After a gap in the samples, or a change of configuration: judges what there is of a movement.
    Judged end_movement(const SetProblem& problem, std::span<const double> health_in3_per_psi);
    /// A reading of the link was impossible.
    void note_impossible(std::size_t position);

private:
    Judged judge_movement(const SetProblem& problem, std::span<const double> health_in3_per_psi);
    void note_senseless(const SetProblem& problem, const MovementSamples& movement,
                        std::span<const Deviation> deviations);

    hydraulics::Sampling sampling_;
    State state_;
};

} // namespace placedpar::identification
