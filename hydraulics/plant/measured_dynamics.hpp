#pragma once

#include "hydraulics/circuit/flow_split.hpp"
#include "hydraulics/plant/measured_excavator.hpp"

#include <cstddef>
#include <vector>

namespace placedpar::hydraulics {

/// The differential equations of the detailed model of the boom (measured_excavator.hpp), which event_step.hpp solves.
/// On each side of the piston a hose connects the valve and the cylinder.
///
///   inlet: C_v P_v' = Q_i - q, I q' = P_v - P_c - R q, C_c P_c' = q - A_i v - Q_l;
///   drain: C_c P_oc' = A_o v + Q_l - q_o, I q_o' = P_oc - P_ov - R q_o, C_v P_ov' = q_o - Q_o;
///   piston: M v' = A_i P_c - A_o P_oc - F_g - b v - friction(v, z), Q_l = k_l (P_c - P_oc);
///   spool: spool' = a_0 (desired - spool).
///
/// P_v and P_c are the pressures at a hose's two ends, C_v and C_c the compliances there, and q is the flow in the
/// hose. I and R are the hose's inertance and resistance. z is the bending of the friction's bristles, and F_g is the
/// load. Equations 3.1 to 3.3 give Q_i, the part of the rippling pump flow that enters the inlet hose. Equation 3.4
/// gives Q_o, the flow to the tank.
class MeasuredDynamics {
public:
    enum Component : std::size_t {
        inlet_psi,
        inlet_hose_in3_per_s,
        inlet_cylinder_psi,
        outlet_cylinder_psi,
        outlet_hose_in3_per_s,
        outlet_psi,
        piston_in,
        velocity_in_per_s,
        bristle_in,
        spool_in,
        components
    };
    using State = std::vector<double>;
    /// The discrete state: which valves are open, and which branch of the spool's curves applies.
    struct Mode {
        bool inlet_open = false;
        bool relieving = false;
        bool leaking = false;
        int spool_branch = 0;

        friend bool operator==(const Mode&, const Mode&) = default;
    };

    /// REQUIRES: the excavator outlives this object.
    explicit MeasuredDynamics(const MeasuredExcavator& excavator) : excavator_(excavator) { hold(0); }

    State at_rest() const;
    /// Fixes the drift, and the command delayed by the dead time, at their values at `time_s`.
    void hold(double time_s);
    /// Fixes the voltage at `volts`, and the drift at its value at `time_s`.
    void hold(double volts, double time_s);
    /// Computes the derivative, and returns the mode in which the derivative is valid.
    Mode rate(const State& state, State& derivative, double time_s) const;
    /// Returns the pump's flow, with its ripple.
    double pump_in3_per_s(double time_s) const;
    FlowSplit flows(const State& state, double time_s) const;
    double leak_in3_per_s(const State& state, double time_s) const;

private:
    FlowConstants flow_at(double time_s) const;
    double acceleration(const State& state) const;

    const MeasuredExcavator& excavator_;
    double desired_spool_in_ = 0;
};

/// Returns the flow of the drain side through an orifice (3.4), in either direction. Near a drop of 0 the flow is
/// laminar, because the root of equation 3.4 has an infinite slope there: Q = k a drop / (drop^2 + laminar^2)^(1/4).
double drain_in3_per_s(double outlet_in2, double drop_psi, double laminar_psi, const FlowConstants& flow);

} // namespace placedpar::hydraulics
