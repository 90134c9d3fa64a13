#include "hydraulics/boom_problem.hpp"

namespace placedpar {

std::vector<std::string> BoomProblem::parameter_names() const { return {"C_BOi"}; }

std::vector<std::string> BoomProblem::parameter_units() const { return {"in^3/psi"}; }

std::vector<double> BoomProblem::true_parameters() const {
    if (true_compliance_)
        return {*true_compliance_};
    return {};
}

} // namespace placedpar
