#pragma once

#include "hydraulics/circuit/cross_over.hpp"
#include "hydraulics/circuit/link_sample.hpp"
#include "hydraulics/circuit/main_valve.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace placedpar::hydraulics {

/// The valve areas, pressures and piston positions of all links at one instant, as measured.
struct ValveReading {
    ValveLinks links;
    PerLink<double> piston_in3; ///< volume behind the piston: piston_in3_per_rad times the joint's angle

    friend bool operator==(const ValveReading&, const ValveReading&) = default;
};

/// The state and the flows of the main valve between two successive readings.
struct ValveInterval {
    ValveReading end{};
    Configuration configuration = Configuration::a; ///< at the end of the interval
    PerLink<double> junction_psi{};                 ///< at the end of the interval
    ValveFlows mean{};                              ///< mean flows, without the relief valve's flow
    /// How badly the configuration explains the motion: the sum over the links of (oil_in3_per_s - mean.inlet)^2.
    double misfit = 0;
    PerLink<double> oil_in3_per_s{}; ///< flow that moves the piston and expands the hose, smoothed
    PerLink<double> forward_s{};     ///< time since oil last flowed out of the cylinder

    friend bool operator==(const ValveInterval&, const ValveInterval&) = default;
};

/// Recognises the configuration of the main valve from the readings of all links. The configuration says which pump
/// feeds which link, and identification needs it to choose its equations. No sensor reads the configuration.
///
/// The pressures at the valve's junctions are integrated from the areas and the cylinders' pressures. From these
/// pressures, the rule by which the cross-over valves move gives the configuration (cross_over.hpp). If a pressure just
/// reaches a limit of the rule, noise decides, and the configuration may be wrong for seconds. Therefore the computed
/// flows into the cylinders are compared with the flows that move the pistons and expand the hoses. If another
/// configuration, to which the valves may have changed within the last `reach` intervals, explains these flows much
/// better, it replaces the present configuration.
class ConfigurationWatch {
public:
    static constexpr std::size_t reach = 4; ///< number of intervals
    /// The number of intervals over which a sample averages. It is high, so that noise hardly changes the slopes.
    static constexpr std::size_t span = 8;

    /// Holds everything that is needed to restore the object.
    struct State {
        ValveInterval last;
        /// At most span + 1 intervals, oldest first. Of the oldest, only its end is used.
        std::vector<ValveInterval> recent;

        friend bool operator==(const State&, const State&) = default;
    };

    /// `compliance_in3_per_psi` has the compliances of healthy links. The true compliances may differ from them by up
    /// to a third.
    ConfigurationWatch(const MainValve&, const CrossOverLimits&, const PerLink<double>& compliance_in3_per_psi,
                       double period_s);

    const State& state() const { return state_; }
    /// Continues from a saved state. REQUIRES: the state is of an object that was constructed with the same arguments.
    void go_on_from(State state) { state_ = std::move(state); }

    /// Takes the next reading, one period after the last reading.
    void take(const ValveReading&);
    /// Forgets the recent intervals, but keeps the configuration. Call it after a gap in the readings.
    void restart();

    Configuration configuration() const { return state_.last.configuration; }
    const ValveInterval& last() const { return state_.last; }
    /// Returns the links into which oil flowed during all of the last `span` intervals, and which have moved forward
    /// long enough for the return orifice to be shut. Returns the empty set if the configuration changed in these
    /// intervals.
    LinkSet driven() const;
    /// Returns the means over the last `span` intervals as samples of this circuit, for the identification of
    /// compliances. Some flows are not in the circuit's model: the oil stored in pipes, the flows at links at rest, and
    /// the flows into other links. These flows are added to the piston's flow and to the bypass. Returns nullopt if the
    /// readings contradict the circuit. REQUIRES: driven() contains the links of the circuit.
    std::optional<std::vector<LinkSample>> samples(const Circuit&) const;

private:
    ValveInterval next(const ValveInterval& from, const ValveReading& to, bool held) const;
    /// Adds the flows of one integration step to `now.mean`, at the mean of the junctions' pressures before and after
    /// the step.
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
