#pragma once

#include "hydraulics/circuit/circuit.hpp"
#include "hydraulics/circuit/flow_constants.hpp"
#include "hydraulics/circuit/link_sample.hpp"
#include "hydraulics/data/sampling.hpp"

#include <cstddef>
#include <vector>

namespace placedpar::identification {

/// One LinkSample for each link, in the order of the circuit's junctions.
using JunctionSamples = std::vector<hydraulics::LinkSample>;

/// What is kept of one movement of an operator: the samples at rest before the valves open, those that follow while all
/// of them are open, and those at rest after they have shut. All that a restart needs.
struct MovementSamples {
    std::vector<JunctionSamples> at_rest, moving, rest_after; ///< oldest first

    friend bool operator==(const MovementSamples&, const MovementSamples&) = default;
};

/// Cuts a stream of samples into movements. All lengths are ours, and seconds but for those of slopes.
class Movement {
public:
    struct State {
        MovementSamples samples;
        std::vector<JunctionSamples> shut; ///< the newest: of the rest, if the valves stay shut for two samples more
        std::size_t opened = 0;            ///< samples since the valves opened
        std::size_t closed = 0;            ///< samples since not all of them were open, after a movement

        friend bool operator==(const State&, const State&) = default;
    };

    /// Samples whose slopes, of five points, reach into another state of the valve are left out, and one more, since
    /// the path to a cylinder opens between samples and is judged by readings.
    static constexpr std::size_t slope_reach = 3;
    static constexpr std::size_t slope_ahead = 2; ///< so far they reach when the valves shut, which ends a movement
    static constexpr double rest_s = 1;           ///< so much of it is kept
    static constexpr double piece_s = 4;          ///< a longer movement is judged in pieces
    static constexpr double shut_for_s = 0.06;    ///< after which a movement does not go on
    static constexpr double rest_after_s = 0.4;   ///< for which it then waits, for valves to shut and rest to follow
    static constexpr double open_by_psi = 25;     ///< as UsableSamples
    static constexpr double least_inlet_in2 = 0.0125; ///< .01 in of spool beyond the dead band

    Movement() = default;
    Movement(const hydraulics::Sampling& sampling, State state) : sampling_(sampling), state_(std::move(state)) {}
    const State& state() const { return state_; }
    /// Is the movement over with this sample? REQUIRES: one sample for each junction, one after the other in time.
    bool take(const hydraulics::Circuit& circuit, const hydraulics::FlowConstants& flow, JunctionSamples sample);
    /// Is there one under way?
    bool under_way() const { return !state_.samples.moving.empty(); }
    /// Its samples; the next movement begins with nothing.
    MovementSamples finish();

private:
    void rest(JunctionSamples sample, std::vector<JunctionSamples>& kept, std::size_t most);
    bool move(JunctionSamples sample);
    bool close(JunctionSamples sample);
    /// Would a movement under way go on if the valves opened now?
    bool goes_on() const { return state_.closed < sampling_.samples_in(shut_for_s); }

    hydraulics::Sampling sampling_;
    State state_;
};

} // namespace placedpar::identification
