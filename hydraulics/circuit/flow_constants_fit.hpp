#pragma once

#include "hydraulics/circuit/flow_constants.hpp"

#include <span>
#include <vector>

namespace placedpar::hydraulics {

/// An entry of a table of steady flow: at this spool position and this pressure, this flow enters the cylinder.
struct SteadyFlowPoint {
    double inlet_in3_per_s;
    double inlet_psi;
    double spool_in;
};

/// Returns Table 2.6 of the thesis (printed as "Figure 2.6"), in order of falling flow and, at equal flow, of falling
/// pressure.
std::span<const SteadyFlowPoint> table_2_6();

struct FlowConstantsFit {
    FlowConstants constants;
    FlowConstants deviation;          ///< standard deviation of each constant, computed from the residuals
    std::vector<double> residuals_in; ///< for each entry, the model's spool position minus the table's
    double rms_in;
};

/// Fits three constants to the spool positions: k of the orifices, the pump's flow Q, and the tank's pressure P_e. Uses
/// least squares with the method of Levenberg and Marquardt, which begins at `start`. The relief pressure stays as in
/// `start`. Throws std::invalid_argument for fewer than 4 points, and std::runtime_error if the method does not
/// converge. Throws the std::domain_error of boom_spool_for_flow() (steady_flow.hpp) if no spool position gives a flow
/// of the table.
FlowConstantsFit fit_flow_constants(std::span<const SteadyFlowPoint> table, const FlowConstants& start);

/// Returns the residuals for the given constants, in the form of FlowConstantsFit::residuals_in.
std::vector<double> spool_residuals_in(std::span<const SteadyFlowPoint> table, const FlowConstants& constants);

} // namespace placedpar::hydraulics
