#pragma once

#include "hydraulics/circuit/cross_over.hpp"
#include "hydraulics/circuit/link_sample.hpp"
#include "hydraulics/circuit/main_valve.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace placedpar::hydraulics {

/// The readings of all links at one instant.
struct ValveReading {
    ValveLinks links;
    PerLink<double> piston_in3; ///< piston_in3_per_rad times the joint's angle

    friend bool operator==(const ValveReading&, const ValveReading&) = default;
};

/// The state and the flows of the main valve between two successive readings.
struct ValveInterval {
    ValveReading end{};
    Configuration configuration = Configuration::a; ///< at the end of the interval
    PerLink<double> junction_psi{};                 ///< at the end of the interval
    ValveFlows mean{};                              ///< mean flows, without the relief valve's flow
    double misfit = 0;                              ///< sum over the links of (oil - mean.inlet)^2
    PerLink<double> oil_in3_per_s{};                ///< flow that moves the piston and expands the hose, smoothed
    PerLink<double> forward_s{};                    ///< time since oil last left the cylinder

    friend bool operator==(const ValveInterval&, const ValveInterval&) = default;
};

/// Recognises the configuration of the main valve from the readings of all links.
///
/// The junctions' pressures are integrated from the areas and the cylinders' pressures. As in the machine, the rule of
/// thesis 2.4 then gives the configuration from the junctions' pressures. If a pressure just reaches a limit, the noise
/// of the readings decides, and the rule may stay in the wrong state for seconds. Therefore the flows into the
/// cylinders are compared with the flows that move the pistons and expand the hoses. If a change of the cross-over
/// valves within the last `reach` intervals explains these flows much better, the position after this change replaces
/// the present position.
class ConfigurationWatch {
public:
    static constexpr std::size_t reach = 4; ///< number of intervals
    static constexpr std::size_t span =
        8; ///< number of intervals in a sample; many, so that noise hardly changes the slopes

    /// Holds everything that is needed to restore the object.
    struct State {
        ValveInterval last;
        std::vector<ValveInterval> recent; ///< at most span + 1 intervals, oldest first; only the end of the first is
                                           ///< used

        friend bool operator==(const State&, const State&) = default;
    };

    /// `compliance_in3_per_psi`: compliances of healthy links. True compliances may differ from them by up to a third.
    ConfigurationWatch(const MainValve&, const CrossOverLimits&, const PerLink<double>& compliance_in3_per_psi,
                       double period_s);

    const State& state() const { return state_; }
    /// Continues from a state. REQUIRES: the state of an object with the same constants.
    void go_on_from(State state) { state_ = std::move(state); }

    /// Takes the next reading, one period after the last.
    void take(const ValveReading&);
    /// Forgets the recent intervals, but keeps the configuration. Call it after a gap in the readings.
    void restart();

    Configuration configuration() const { return state_.last.configuration; }
    const ValveInterval& last() const { return state_.last; }
    /// Returns the links into which oil flows all through the last `span` intervals, and that have moved forward for
    /// so long that their outlets are shut. Returns none if the configuration has changed.
    LinkSet driven() const;
    /// Returns the means over the last `span` intervals as samples of this circuit. Flows that the circuit does not
    /// have are added to the piston's flow and to the bypass: the oil stored in pipes, the valves of links at rest, and
    /// the flows into other links. Returns nullopt if the readings contradict the circuit. REQUIRES: driven() contains
    /// the links of the circuit.
    std::optional<std::vector<LinkSample>> samples(const Circuit&) const;

private:
    ValveInterval next(const ValveInterval& from, const ValveReading& to, bool held) const;
    /// Adds the flows of a step, at the mean of the junctions' pressures before and after it.
    void add_flows(ValveInterval& now, const PerLink<double>& before_psi, const ValveLinks& links, double share) const;
    bool near(const ValveInterval&, Configuration other) const;
    void reconsider();
    /// Returns the mean of get(interval) over the last `span` intervals.
    template <class Get>
    double mean(Get get) const;

    MainValve valve_;
    CrossOverLimits limits_;
    PerLink<double> compliance_in3_per_psi_;
    double period_s_;
    State state_;
};

} // namespace placedpar::hydraulics
