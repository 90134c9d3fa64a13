#pragma once

#include "hydraulics/circuit/flow_constants.hpp"

#include <span>
#include <vector>

namespace placedpar::hydraulics {

/// An entry of a table of steady flow: this spool lets this flow through at this pressure.
struct SteadyFlowPoint {
    double inlet_in3_per_s;
    double inlet_psi;
    double spool_in;
};

/// Table 2.6 of the thesis (printed as "Figure 2.6"), by falling flow and, within a flow, by falling pressure.
std::span<const SteadyFlowPoint> table_2_6();

/// Constants fitted to a table, with what is left.
struct FlowConstantsFit {
    FlowConstants constants;
    FlowConstants deviation;          ///< standard deviation of each, from the residuals
    std::vector<double> residuals_in; ///< spool by the model minus spool in the table, for each entry
    double rms_in;
};

/// Least squares of the spool residuals over k, Q and P_e, by Levenberg and Marquardt from `start`; the relief
/// pressure stays as it is. Throws std::invalid_argument for fewer than 4 points, std::runtime_error when it does not
/// converge, and std::domain_error as boom_spool_for_flow.
FlowConstantsFit fit_flow_constants(std::span<const SteadyFlowPoint> table, const FlowConstants& start);

/// The residuals under given constants, as above.
std::vector<double> spool_residuals_in(std::span<const SteadyFlowPoint> table, const FlowConstants& constants);

} // namespace placedpar::hydraulics
