#include "hydraulics/boom_problem.hpp"

namespace placedpar {

std::vector<double> BoomSample::values() const {
    return {inlet_psi, inlet_slope_psi_per_s, piston_flow_in3_per_s, inlet_in2, bypass_in2};
}

std::vector<std::string> BoomProblem::parameter_names() const { return {"C_BOi"}; }

std::vector<std::string> BoomProblem::parameter_units() const { return {"in^3/psi"}; }

std::vector<double> BoomProblem::true_parameters() const {
    if (true_compliance_)
        return {*true_compliance_};
    return {};
}

} // namespace placedpar
