#include "hydraulics/circuit/flow_constants_fit.hpp"

#include "hydraulics/circuit/steady_flow.hpp"

#include <Eigen/LU>
#include <unsupported/Eigen/LevenbergMarquardt>
#include <unsupported/Eigen/NumericalDiff>

#include <array>
#include <cmath>
#include <stdexcept>

namespace placedpar::hydraulics {

namespace {

/// The scales of the solver's variables: k and Q in hundreds, P_e in tens of psi, so that all variables are of order 1.
constexpr double flow_scale = 100, tank_scale = 10;

Eigen::VectorXd scaled(const FlowConstants& constants) {
    return Eigen::Vector3d(constants.orifice_in3_per_s_in2_sqrt_psi / flow_scale, constants.pump_in3_per_s / flow_scale,
                           constants.tank_psi / tank_scale);
}

FlowConstants unscaled(const Eigen::VectorXd& x, double relief_psi) {
    return {x[0] * flow_scale, x[1] * flow_scale, x[2] * tank_scale, relief_psi};
}

struct SpoolResiduals : Eigen::DenseFunctor<double> {
    SpoolResiduals(std::span<const SteadyFlowPoint> points, double relief)
        : DenseFunctor(3, static_cast<int>(points.size())), table(points), relief_psi(relief) {}

    int operator()(const Eigen::VectorXd& x, Eigen::VectorXd& residuals) const {
        FlowConstants constants = unscaled(x, relief_psi);
        for (Eigen::Index i = 0; i < residuals.size(); ++i) {
            const SteadyFlowPoint& point = table[static_cast<std::size_t>(i)];
            residuals[i] = boom_spool_for_flow(point.inlet_in3_per_s, point.inlet_psi, constants) - point.spool_in;
        }
        return 0;
    }

    std::span<const SteadyFlowPoint> table;
    double relief_psi;
};

/// Returns the standard deviations of the fitted constants, from the inverse of the normal matrix times the residual
/// variance.
FlowConstants deviation_of(const Eigen::VectorXd& x, const Eigen::NumericalDiff<SpoolResiduals>& problem,
                           double squares) {
    Eigen::MatrixXd slopes(problem.values(), problem.inputs());
    problem.df(x, slopes);
    double variance = squares / (problem.values() - problem.inputs());
    Eigen::Matrix3d normal = slopes.transpose() * slopes;
    Eigen::Vector3d deviation = (variance * normal.inverse().diagonal()).cwiseSqrt();
    return unscaled(deviation, 0);
}

} // namespace

std::span<const SteadyFlowPoint> table_2_6() {
    static constexpr SteadyFlowPoint table[]{
        {.inlet_in3_per_s = 60, .inlet_psi = 2030, .spool_in = 0.2741},
        {.inlet_in3_per_s = 60, .inlet_psi = 1830, .spool_in = 0.2688},
        {.inlet_in3_per_s = 60, .inlet_psi = 1630, .spool_in = 0.2627},
        {.inlet_in3_per_s = 50, .inlet_psi = 2030, .spool_in = 0.2650},
        {.inlet_in3_per_s = 50, .inlet_psi = 1830, .spool_in = 0.2592},
        {.inlet_in3_per_s = 50, .inlet_psi = 1630, .spool_in = 0.2527},
        {.inlet_in3_per_s = 40, .inlet_psi = 2030, .spool_in = 0.2561},
        {.inlet_in3_per_s = 40, .inlet_psi = 1830, .spool_in = 0.2499},
        {.inlet_in3_per_s = 40, .inlet_psi = 1630, .spool_in = 0.2427},
    };
    return table;
}

FlowConstantsFit fit_flow_constants(std::span<const SteadyFlowPoint> table, const FlowConstants& start) {
    if (table.size() < 4)
        throw std::invalid_argument("a fit of three constants needs at least four points");
    Eigen::NumericalDiff<SpoolResiduals> problem(SpoolResiduals(table, start.relief_psi), 1e-10);
    Eigen::LevenbergMarquardt<Eigen::NumericalDiff<SpoolResiduals>> solver(problem);
    solver.setXtol(1e-10);
    solver.setFtol(1e-10);
    Eigen::VectorXd x = scaled(start);
    auto status = solver.minimize(x);
    if (status <= 0 || status == Eigen::LevenbergMarquardtSpace::TooManyFunctionEvaluation)
        throw std::runtime_error("the fit of the flow constants does not converge from these first values");
    FlowConstants constants = unscaled(x, start.relief_psi);
    std::vector<double> residuals = spool_residuals_in(table, constants);
    double squares = 0;
    for (double residual : residuals)
        squares += residual * residual;
    return {constants, deviation_of(x, problem, squares), residuals,
            std::sqrt(squares / static_cast<double>(table.size()))};
}

std::vector<double> spool_residuals_in(std::span<const SteadyFlowPoint> table, const FlowConstants& constants) {
    std::vector<double> residuals;
    for (const SteadyFlowPoint& point : table)
        residuals.push_back(boom_spool_for_flow(point.inlet_in3_per_s, point.inlet_psi, constants) - point.spool_in);
    return residuals;
}

} // namespace placedpar::hydraulics
