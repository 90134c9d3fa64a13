#pragma once

#include "hydraulics/circuit/circuit.hpp"
#include "hydraulics/circuit/flow_constants.hpp"

namespace placedpar::hydraulics {

class Parameters; // hydraulics/data/parameters.hpp

/// The pressures that decide which pump feeds which link (thesis 2.4). Branch n is the oil line of pump n.
/// It passes three places in this order: the junction of the pump's first link, a check valve, and the junction of its
/// second link. This project has only the caption of Figure 2.10 and not
/// its drawing, so this meaning of a branch is an interpretation.
struct BranchPressures {
    double p12_psi; ///< branch 1 before its check valve: past the bucket
    double p13_psi; ///< branch 1 behind its check valve: at the boom
    double p22_psi; ///< branch 2 before its check valve: past the swing
    double p23_psi; ///< branch 2 behind its check valve: at the stick
};

/// Returns the branches' pressures, given the pressures at the junctions of the links.
BranchPressures branch_pressures(const PerLink<double>& junction_psi);

/// The areas of the main valve's orifices and the pressures behind its inlets, for each link.
struct ValveLinks {
    PerLink<double> inlet_psi, inlet_in2, bypass_in2; ///< areas >= 0

    friend bool operator==(const ValveLinks&, const ValveLinks&) = default;
};

/// The flows that leave the junction of each link, in in^3/s and >= 0.
struct ValveFlows {
    PerLink<double> inlet, bypass, relief;

    friend bool operator==(const ValveFlows&, const ValveFlows&) = default;
};

/// A model of the main valve whose pipes have a volume: as the pressure at a link's junction rises, the pipe there
/// stores oil. All flows then follow directly from the pressures.
struct MainValve {
    FlowConstants flow{};
    double pipe_in3_per_psi = 0; ///< compliance of the oil at each junction: volume / bulk modulus
    double laminar_psi = 0;      ///< below this pressure drop, a flow is proportional to the drop and not to its root

    /// Returns the flow through an orifice with a check valve.
    double one_way(double area_in2, double drop_psi) const;
    ValveFlows flows(Configuration, const PerLink<double>& junction_psi, const ValveLinks&) const;
    /// Returns how fast the junctions' pressures change, in psi/s.
    PerLink<double> rates(Configuration, const ValveFlows&) const;
};

/// Reads the parameters flow.*, pipe.volume, oil.bulk_modulus and valve.drain_laminar.
MainValve main_valve(const Parameters& parameters);

} // namespace placedpar::hydraulics
