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

/// The samples of one movement that an operator makes. They are at rest before the valves open, while all valves are
/// open, and at rest after the valves have shut.
struct MovementSamples {
    std::vector<JunctionSamples> at_rest, moving, rest_after; ///< oldest first

    friend bool operator==(const MovementSamples&, const MovementSamples&) = default;
};

/// Cuts a stream of samples into movements, which are judged one by one. All constants are this project's choice.
/// `slope_reach` and `slope_ahead` are numbers of samples.
class Movement {
public:
    struct State {
        MovementSamples samples;
        /// The newest samples with shut valves. A sample counts as rest when three more samples with shut valves have
        /// followed.
        std::vector<JunctionSamples> shut;
        std::size_t opened = 0; ///< number of samples since the valves opened
        std::size_t closed = 0; ///< number of samples since all valves were last open

        friend bool operator==(const State&, const State&) = default;
    };

    /// The number of samples to leave out before a valve opens, after it has opened, and after it has shut. A slope
    /// uses two samples on either side, and the valve must have the same state in all of them. A third sample is left
    /// out because the path to a cylinder opens between two samples and readings have noise.
    static constexpr std::size_t slope_reach = 3;
    /// The number of samples to leave out at the end of a movement, since their slopes use later samples.
    static constexpr std::size_t slope_ahead = 2;
    static constexpr double rest_s = 1;        ///< the last second of the rest before a movement is kept
    static constexpr double piece_s = 4;       ///< a longer movement is judged in pieces of this length
    static constexpr double shut_for_s = 0.06; ///< if the valves open again within this time, the movement continues
    /// A movement ends this further time after `shut_for_s`. In this time the valves shut completely, and samples at
    /// rest are taken.
    static constexpr double rest_after_s = 0.4;
    /// The valves count as open only if oil would flow in even at a pressure higher by this margin.
    static constexpr double open_by_psi = 25;
    /// A valve is open if its inlet has at least this area: the area at 0.01 in beyond the spool's dead band.
    static constexpr double least_inlet_in2 = 0.0125;

    Movement() = default;
    Movement(const hydraulics::Sampling& sampling, State state) : sampling_(sampling), state_(std::move(state)) {}
    const State& state() const { return state_; }
    /// Adds a sample and returns whether it ends the movement. REQUIRES: one LinkSample per junction; samples follow
    /// each other in time.
    bool take(const hydraulics::Circuit& circuit, const hydraulics::FlowConstants& flow, JunctionSamples sample);
    /// Returns whether a movement is in progress.
    bool under_way() const { return !state_.samples.moving.empty(); }
    /// Ends the movement and returns its samples.
    MovementSamples finish();

private:
    void rest(JunctionSamples sample, std::vector<JunctionSamples>& kept, std::size_t most);
    bool move(JunctionSamples sample);
    bool close(JunctionSamples sample);
    /// Returns whether the pause is still short, so that the movement would continue if the valves opened now.
    bool goes_on() const { return state_.closed < sampling_.samples_in(shut_for_s); }

    hydraulics::Sampling sampling_;
    State state_;
};

} // namespace placedpar::identification
