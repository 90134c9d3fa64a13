#include "identification/verdict/deviation.hpp"

#include "hydraulics/circuit/boom_orifices.hpp"
#include "hydraulics/circuit/circuit_error.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace placedpar::identification {

using namespace hydraulics;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr Eigen::Index ways = all_ways.size();
/// Neighbouring errors that are correlated: two 5-point slopes that share a sample, and one more.
constexpr Eigen::Index lag = 5;
/// Slopes share their samples with two on either side: their errors say less than so many free ones.
constexpr double overlap = 3;
constexpr std::size_t fewest_at_rest = 4;
/// Of a converter and of friction, (in^3/s)^2: samples at rest are not trusted beyond it.
constexpr double least_variance_at_rest = 0.05;
/// The share of the slopes' noise by which it may be known wrongly: 50 readings and a median.
constexpr double noise_known_within = 0.3;
/// Before a movement is seen, a link may be off by ten units in any way.
constexpr double prior_units = 10;

Eigen::Index row_of(std::size_t junction) { return ways * static_cast<Eigen::Index>(junction); }

/// Where the spool of the boom's valve stands by the inlet that it opens: A.5 and A.6 the other way round.
double spool_in_of(double inlet_in2) {
    constexpr double steep_in2 = 1.247 * (boom_bypass_shut_in - boom_dead_band_in);
    return inlet_in2 <= steep_in2 ? boom_dead_band_in + inlet_in2 / 1.247
                                  : boom_bypass_shut_in + (inlet_in2 - steep_in2) / 3.927;
}

/// The areas of a spool that stands elsewhere by `moved_in`. Of links whose orifices are not the boom's, too: by as
/// much as the boom's would change.
LinkSample with_spool_moved(LinkSample link, double moved_in) {
    double spool = spool_in_of(link.inlet_in2);
    OrificeAreas here = boom_orifices(spool), there = boom_orifices(spool + moved_in);
    link.inlet_in2 += there.inlet_in2 - here.inlet_in2;
    link.bypass_in2 = std::max(0.0, link.bypass_in2 + there.bypass_in2 - here.bypass_in2);
    return link;
}

/// The equations of a circuit near health: what a unit of each way changes in the flow that is missed.
class Regression {
public:
    Regression(const Circuit& circuit, const FlowConstants& flow, std::span<const LinkInHealth> links)
        : circuit_(circuit), flow_(flow), links_(links) {
        for (const LinkInHealth& link : links) {
            compliances_.push_back(link.compliance_in3_per_psi);
            units_.push_back(WayUnits::of(link.compliance_in3_per_psi));
        }
    }

    Eigen::Index unknowns() const { return row_of(circuit_.size()); }

    VectorXd missed(const JunctionSamples& samples, const std::vector<double>& compliances) const {
        auto missing = missing_flows_in3_per_s<double>(circuit_, compliances, samples, flow_, InletFlow::as_signed);
        return Eigen::Map<const VectorXd>(missing.data(), static_cast<Eigen::Index>(circuit_.size()));
    }
    VectorXd missed(const JunctionSamples& samples) const { return missed(samples, compliances_); }

    /// A row a junction, a column an unknown.
    MatrixXd slopes(const JunctionSamples& samples) const {
        MatrixXd slopes(static_cast<Eigen::Index>(circuit_.size()), unknowns());
        for (std::size_t j = 0; j < circuit_.size(); ++j) {
            slopes.col(row_of(j)) = by_compliance(samples, j) * units_[j].compliance_in3_per_psi;
            slopes.col(row_of(j) + 1) = by_leak(samples, j) * units_[j].leak_in3_per_s_psi;
            if (links_[j].areas == AreasFrom::areas)
                slopes.col(row_of(j) + 2).setZero();
            else
                slopes.col(row_of(j) + 2) = by_offset(samples, j) * units_[j].offset_in;
        }
        return slopes;
    }

    /// At rest: what flows into the cylinder of a link whose inlet is shut, and what a unit of each way adds.
    double missed_at_rest(const LinkSample& link, std::size_t junction) const {
        return -cylinder_flow(link.piston_flow_in3_per_s, link.inlet_slope_psi_per_s, compliances_[junction]);
    }
    Eigen::Vector3d slopes_at_rest(const LinkSample& link, std::size_t junction) const {
        return {-link.inlet_slope_psi_per_s * units_[junction].compliance_in3_per_psi,
                -link.inlet_psi * units_[junction].leak_in3_per_s_psi, 0};
    }

    const std::vector<WayUnits>& units() const { return units_; }

private:
    VectorXd by_compliance(const JunctionSamples& samples, std::size_t junction) const {
        const double step = 1e-3 * units_[junction].compliance_in3_per_psi;
        auto more = compliances_, less = compliances_;
        more[junction] += step;
        less[junction] -= step;
        return (missed(samples, more) - missed(samples, less)) / (2 * step);
    }
    /// A leak past the piston takes k_l P, as though the piston took more.
    VectorXd by_leak(const JunctionSamples& samples, std::size_t junction) const {
        const double step = 1e-3 * units_[junction].leak_in3_per_s_psi;
        auto more = samples, less = samples;
        more[junction].piston_flow_in3_per_s += step * samples[junction].inlet_psi;
        less[junction].piston_flow_in3_per_s -= step * samples[junction].inlet_psi;
        return (missed(more) - missed(less)) / (2 * step);
    }
    /// A reading that is too high is of a spool that stands lower.
    VectorXd by_offset(const JunctionSamples& samples, std::size_t junction) const {
        const double step = 0.1 * units_[junction].offset_in;
        auto lower = samples, higher = samples;
        lower[junction] = with_spool_moved(samples[junction], -step);
        higher[junction] = with_spool_moved(samples[junction], step);
        return (missed(lower) - missed(higher)) / (2 * step);
    }

    const Circuit& circuit_;
    const FlowConstants& flow_;
    std::span<const LinkInHealth> links_;
    std::vector<double> compliances_;
    std::vector<WayUnits> units_;
};

/// Rows of one kind whose errors have one variance.
struct Rows {
    MatrixXd slopes;
    VectorXd missed;
    double variance = 1;

    Eigen::Index size() const { return missed.size(); }
    VectorXd errors(const VectorXd& by) const { return missed + slopes * by; }
    MatrixXd information() const { return slopes.transpose() * slopes / variance; }
    void add_to(MatrixXd& to_information, VectorXd& pull) const {
        to_information += information();
        pull -= slopes.transpose() * missed / variance;
    }
};

Rows moving_rows(const Regression& regression, const MovementSamples& movement, std::size_t junction) {
    const auto count = static_cast<Eigen::Index>(movement.moving.size());
    const auto row = static_cast<Eigen::Index>(junction);
    Rows rows{MatrixXd(count, regression.unknowns()), VectorXd(count)};
    for (Eigen::Index i = 0; i < count; ++i) {
        const JunctionSamples& samples = movement.moving[static_cast<std::size_t>(i)];
        rows.slopes.row(i) = regression.slopes(samples).row(row);
        rows.missed[i] = regression.missed(samples)[row];
    }
    return rows;
}

Rows rows_at_rest(const Regression& regression, const MovementSamples& movement, std::size_t junction) {
    const auto count = static_cast<Eigen::Index>(movement.at_rest.size());
    Rows rows{MatrixXd::Zero(count, regression.unknowns()), VectorXd(count)};
    for (Eigen::Index i = 0; i < count; ++i) {
        const LinkSample& link = movement.at_rest[static_cast<std::size_t>(i)][junction];
        rows.slopes.block<1, ways>(i, row_of(junction)) = regression.slopes_at_rest(link, junction).transpose();
        rows.missed[i] = regression.missed_at_rest(link, junction);
    }
    return rows;
}

/// The variance of a pressure's slopes that is noise, by the median of their fourth differences, which are next to 0 of
/// what is smooth. White noise of the pressure, through the 5-point line, gives the differences 25.2 times the variance
/// that it gives the slopes. Ripple counts: it spoils the slopes as noise does.
double slope_noise_variance(const MovementSamples& movement, std::size_t junction) {
    const std::vector<JunctionSamples>& moving = movement.moving;
    auto slope = [&](std::size_t i) { return moving[i][junction].inlet_slope_psi_per_s; };
    std::vector<double> differences;
    for (std::size_t i = 4; i < moving.size(); ++i)
        differences.push_back(
            std::abs(slope(i) - 4 * slope(i - 1) + 6 * slope(i - 2) - 4 * slope(i - 3) + slope(i - 4)));
    auto middle = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
    std::ranges::nth_element(differences, middle);
    constexpr double median_of_normal = 0.6745, gain = 25.2;
    return *middle * *middle / (median_of_normal * median_of_normal * gain);
}

/// What the noise of a link's slopes adds to the information of its compliance, which would come out too small by it
/// (errors in variables).
double noise_information(const MovementSamples& movement, const std::vector<Rows>& moving, const WayUnits& units,
                         std::size_t junction) {
    double sum = 0;
    for (const Rows& rows : moving)
        for (Eigen::Index i = 0; i < rows.size(); ++i) {
            const double psi = movement.moving[static_cast<std::size_t>(i)][junction].inlet_psi;
            const double by_flow = rows.slopes(i, row_of(junction) + 1) / (units.leak_in3_per_s_psi * psi);
            const double by_slope = by_flow * units.compliance_in3_per_psi;
            sum += by_slope * by_slope / rows.variance;
        }
    return sum * slope_noise_variance(movement, junction);
}

/// The variance at rest is about the leak that explains it best: nothing else is told apart there.
double variance_at_rest(const Rows& rows, std::size_t junction) {
    VectorXd by_leak = rows.slopes.col(row_of(junction) + 1);
    double leak = -by_leak.dot(rows.missed) / by_leak.squaredNorm();
    return (rows.missed + leak * by_leak).squaredNorm() / static_cast<double>(rows.size() - 1) + least_variance_at_rest;
}

/// The variance of what least squares of these rows alone leave.
double variance_left(const std::vector<Rows>& moving, const Rows& rows) {
    const Eigen::Index unknowns = rows.slopes.cols();
    MatrixXd information = 1e-9 * MatrixXd::Identity(unknowns, unknowns);
    VectorXd pull = VectorXd::Zero(unknowns);
    for (const Rows& each : moving)
        each.add_to(information, pull);
    VectorXd by = information.ldlt().solve(pull);
    return rows.errors(by).squaredNorm() / static_cast<double>(rows.size() - ways);
}

/// The sum of the products of rows' pulls that lie up to `lag` apart, with Bartlett's weights.
MatrixXd correlated_pulls(const std::vector<Rows>& moving, const VectorXd& by) {
    const Eigen::Index unknowns = by.size(), count = moving.front().size();
    MatrixXd pulls = MatrixXd::Zero(count, unknowns);
    for (const Rows& rows : moving)
        pulls += (rows.slopes.array().colwise() * (rows.errors(by) / rows.variance).array()).matrix();
    MatrixXd sum = pulls.transpose() * pulls;
    for (Eigen::Index apart = 1; apart <= std::min(lag, count - 1); ++apart) {
        MatrixXd product = pulls.topRows(count - apart).transpose() * pulls.bottomRows(count - apart);
        sum += (1 - static_cast<double>(apart) / static_cast<double>(lag + 1)) * (product + product.transpose());
    }
    return sum;
}

/// The normal equations of a movement.
struct Equations {
    MatrixXd information; ///< of all rows, noise included
    VectorXd pull;
    VectorXd noise;     ///< what is noise of each unknown's information
    VectorXd in_health; ///< of each unknown, what it is in health, in its unit: the noise spoils all of it
    MatrixXd moving;    ///< the information of the moving rows alone
    MatrixXd others;    ///< of the pulls of all other rows: the covariance
};

/// Nothing is known but that a link is hardly off by more than prior_units.
Equations before_movement(Eigen::Index unknowns) {
    const VectorXd none = VectorXd::Zero(unknowns);
    const MatrixXd prior = MatrixXd::Identity(unknowns, unknowns) / (prior_units * prior_units);
    return {prior, none, none, none, MatrixXd::Zero(unknowns, unknowns), prior};
}

void add_rest(Equations& equations, Rows rest, std::size_t junction) {
    rest.variance = variance_at_rest(rest, junction);
    rest.add_to(equations.information, equations.pull);
    equations.others += overlap * rest.information();
}

std::vector<Rows> weighted_rows(const Regression& regression, const MovementSamples& movement, std::size_t junctions) {
    std::vector<Rows> moving;
    for (std::size_t j = 0; j < junctions; ++j)
        moving.push_back(moving_rows(regression, movement, j));
    std::vector<double> variances;
    for (const Rows& rows : moving)
        variances.push_back(variance_left(moving, rows));
    for (std::size_t j = 0; j < junctions; ++j)
        moving[j].variance = variances[j];
    return moving;
}

std::vector<Deviation> parts(const VectorXd& by, const MatrixXd& covariance) {
    std::vector<Deviation> deviations;
    for (Eigen::Index first = 0; first < by.size(); first += ways)
        deviations.push_back({by.segment<ways>(first), covariance.block<ways, ways>(first, first)});
    return deviations;
}

std::optional<std::vector<Deviation>> solve(const Equations& equations, const std::vector<Rows>& moving) {
    MatrixXd information = equations.information;
    information.diagonal() -= equations.noise;
    if (information.llt().info() != Eigen::Success)
        return std::nullopt;
    const MatrixXd inverse = information.inverse();
    const VectorXd by = inverse * (equations.pull + equations.noise.cwiseProduct(equations.in_health));
    const VectorXd unsure = noise_known_within * equations.noise.cwiseProduct(equations.in_health + by);
    MatrixXd pulls = (correlated_pulls(moving, by) + overlap * equations.moving) / 2 + equations.others;
    pulls.diagonal() += unsure.cwiseProduct(unsure);
    return parts(by, inverse * pulls * inverse);
}

} // namespace

double Deviation::standard_error(Way way) const {
    auto i = static_cast<Eigen::Index>(way);
    return std::sqrt(covariance(i, i));
}

Eigen::Matrix3d Deviation::information() const {
    Eigen::Matrix3d with_scatter = covariance;
    with_scatter.diagonal().array() += repeats_within * repeats_within;
    return with_scatter.inverse();
}

std::optional<std::vector<Deviation>> deviations(const Circuit& circuit, const FlowConstants& flow,
                                                 std::span<const LinkInHealth> links, const MovementSamples& movement) {
    if (movement.moving.size() < fewest_moving)
        return std::nullopt;
    Regression regression(circuit, flow, links);
    std::vector<Rows> moving = weighted_rows(regression, movement, circuit.size());
    Equations equations = before_movement(regression.unknowns());
    for (std::size_t j = 0; j < circuit.size(); ++j) {
        moving[j].add_to(equations.information, equations.pull);
        equations.moving += moving[j].information();
        if (movement.at_rest.size() >= fewest_at_rest)
            add_rest(equations, rows_at_rest(regression, movement, j), j);
        equations.in_health[row_of(j)] = 1 / WayUnits::compliance_share;
        equations.noise[row_of(j)] = noise_information(movement, moving, regression.units()[j], j);
    }
    return solve(equations, moving);
}

} // namespace placedpar::identification
