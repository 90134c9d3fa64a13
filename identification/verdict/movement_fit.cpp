#include "identification/verdict/movement_fit.hpp"

#include "hydraulics/circuit/boom_orifices.hpp"
#include "hydraulics/circuit/circuit_error.hpp"
#include "identification/verdict/noisy_rows.hpp"
#include "identification/verdict/way_matrices.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace placedpar::identification {

using namespace hydraulics;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr Eigen::Index ways = all_hypotheses.size();
constexpr std::size_t fewest_at_rest = 4;
/// The part of the missing flow's variance, in (in^3/s)^2 for each sample, that sensor noise does not explain. The
/// missing flow is the error of a junction's flow balance. During the movement this part comes from the error of the
/// equations. At rest it comes from the steps of the analogue-to-digital converter and from friction.
constexpr double least_variance_moving = 0.001, least_variance_at_rest = 0.05;
/// The relative error of the estimated noise of the slopes, which is a median over about 50 readings.
constexpr double noise_known_within = 0.3;
/// The greatest difference between the compliances at rest and during the movement, in the units of WayUnits; 0.25
/// units are 5 % of the compliance.
constexpr double compliance_at_rest_within = 0.25;
/// The share by which a leak at rest after a movement may be smaller than during the movement (our choice). The
/// pressure on the other side of the piston reduces the leak, and no sensor reads that pressure.
constexpr double leak_after_within = 0.25;
/// The error of a leak, in the units of WayUnits (our choice), if only the flow during the movement distinguishes the
/// leak from an offset. The equations are not exact: sound simulated machines without noise, or read at 5 kHz, appear
/// to have a leak of -.4 to -2.8 units.
constexpr double leak_by_flow_within = 1.25;
/// The assumed standard deviation of each deviation before a movement is known, in the units of WayUnits.
constexpr double prior_units = 10;

Eigen::Index row_of(std::size_t junction) { return ways * static_cast<Eigen::Index>(junction); }

/// Returns the position of the boom's spool from the inlet area that it opens: the inverse of A.5 and A.6.
double spool_in_of(double inlet_in2) {
    constexpr double steep_in2 = 1.247 * (boom_bypass_shut_in - boom_dead_band_in);
    return inlet_in2 <= steep_in2 ? boom_dead_band_in + inlet_in2 / 1.247
                                  : boom_bypass_shut_in + (inlet_in2 - steep_in2) / 3.927;
}

/// Returns the sample with the areas that it would have if the spool moved by `moved_in`. The areas of other links are
/// assumed to change by as much as the boom's areas.
LinkSample with_spool_moved(LinkSample link, double moved_in) {
    double spool = spool_in_of(link.inlet_in2);
    OrificeAreas here = boom_orifices(spool), there = boom_orifices(spool + moved_in);
    link.inlet_in2 += there.inlet_in2 - here.inlet_in2;
    link.bypass_in2 = std::max(0.0, link.bypass_in2 + there.bypass_in2 - here.bypass_in2);
    return link;
}

/// Computes the imbalance of flow at each junction, one row per junction, and its derivatives, if the links are
/// healthy.
class Balance {
public:
    Balance(const Circuit& circuit, const FlowConstants& flow, std::span<const LinkInHealth> links)
        : circuit_(circuit), flow_(flow), links_(links) {
        for (const LinkInHealth& link : links) {
            compliances_.push_back(link.compliance_in3_per_psi);
            units_.push_back(WayUnits::of(link.compliance_in3_per_psi));
        }
    }

    std::size_t junctions() const { return circuit_.size(); }
    Eigen::Index unknowns() const { return row_of(junctions()); }
    const WayUnits& unit(std::size_t junction) const { return units_[junction]; }
    bool reads_areas(std::size_t junction) const { return links_[junction].areas == AreasFrom::areas; }
    double compliance(std::size_t junction) const { return compliances_[junction]; }

    VectorXd missed(const JunctionSamples& samples) const {
        auto missing = missing_flows_in3_per_s<double>(circuit_, compliances_, samples, flow_, InletFlow::as_signed);
        return Eigen::Map<const VectorXd>(missing.data(), static_cast<Eigen::Index>(circuit_.size()));
    }
    /// The next four functions return the change of the imbalance: per in^3/s into the cylinder, per psi of the link's
    /// pressure, per in^2 of the inlet, and per in^2 of the bypass.
    VectorXd by_flow(const JunctionSamples& samples, std::size_t junction) const {
        return by(samples, 0.01, [&](JunctionSamples& to, double step) { to[junction].piston_flow_in3_per_s += step; });
    }
    VectorXd by_pressure(const JunctionSamples& samples, std::size_t junction) const {
        return by(samples, 0.1, [&](JunctionSamples& to, double step) { to[junction].inlet_psi += step; });
    }
    VectorXd by_inlet(const JunctionSamples& samples, std::size_t junction) const {
        return by(samples, area_step_in2, [&](JunctionSamples& to, double step) { to[junction].inlet_in2 += step; });
    }
    VectorXd by_bypass(const JunctionSamples& samples, std::size_t junction) const {
        return by(samples, area_step_in2, [&](JunctionSamples& to, double step) {
            to[junction].bypass_in2 = std::max(0.0, to[junction].bypass_in2 + step);
        });
    }
    /// Returns the change of the imbalance per inch by which the spool's reading is too high. The true position is
    /// lower than the reading.
    VectorXd by_offset(const JunctionSamples& samples, std::size_t junction) const {
        return by(samples, 0.1 * units_[junction].offset_in,
                  [&](JunctionSamples& to, double step) { to[junction] = with_spool_moved(to[junction], -step); });
    }

private:
    static constexpr double area_step_in2 = 1e-5;

    VectorXd by(const JunctionSamples& samples, double step,
                const std::function<void(JunctionSamples&, double)>& change) const {
        auto more = samples, less = samples;
        change(more, step);
        change(less, -step);
        return (missed(more) - missed(less)) / (2 * step);
    }

    const Circuit& circuit_;
    const FlowConstants& flow_;
    std::span<const LinkInHealth> links_;
    std::vector<double> compliances_;
    std::vector<WayUnits> units_;
};

struct ReadingNoise {
    double psi, slope_psi_per_s, flow_in3_per_s, inlet_in2, bypass_in2, spool_in;
};

ReadingNoise reading_noise(const MovementSamples& movement, std::size_t junction) {
    auto of = [&](auto value, double gain) {
        std::vector<double> values;
        for (const JunctionSamples& samples : movement.moving)
            values.push_back(value(samples[junction]));
        return std::sqrt(noise_variance(values, gain));
    };
    return {of([](const LinkSample& link) { return link.inlet_psi; }, white_gain),
            of([](const LinkSample& link) { return link.inlet_slope_psi_per_s; }, slope_gain),
            of([](const LinkSample& link) { return link.piston_flow_in3_per_s; }, slope_gain),
            of([](const LinkSample& link) { return link.inlet_in2; }, white_gain),
            of([](const LinkSample& link) { return link.bypass_in2; }, white_gain),
            of([](const LinkSample& link) { return spool_in_of(link.inlet_in2); }, white_gain)};
}

/// Returns a matrix with change(sample) as the column of each moving sample, and one row per junction.
template <class Change>
MatrixXd by_sample(const MovementSamples& movement, std::size_t junctions, const Change& change) {
    MatrixXd columns(static_cast<Eigen::Index>(junctions), static_cast<Eigen::Index>(movement.moving.size()));
    for (Eigen::Index i = 0; i < columns.cols(); ++i)
        columns.col(i) = change(movement.moving[static_cast<std::size_t>(i)]);
    return columns;
}

/// The linear equations of a movement, with a row for each junction of each sample. For each link, also the noise in
/// the column of its compliance.
struct MovingRows {
    NoisyRows rows;
    std::vector<Sparse> compliance_noise;
};

/// Adds the effect of the valve's white noise on the missing flows.
void add_valve_noise(NoisyRows& rows, const Balance& balance, const MovementSamples& movement, std::size_t junction,
                     const ReadingNoise& noise) {
    auto add = [&](double deviation, auto change) {
        rows.add_noise(white_noise(deviation * by_sample(movement, balance.junctions(), change)));
    };
    if (balance.reads_areas(junction)) {
        add(noise.inlet_in2, [&](const JunctionSamples& samples) { return balance.by_inlet(samples, junction); });
        add(noise.bypass_in2, [&](const JunctionSamples& samples) { return balance.by_bypass(samples, junction); });
    } else {
        add(noise.spool_in, [&](const JunctionSamples& samples) { return balance.by_offset(samples, junction); });
    }
}

/// Sets the columns of a link in the equations: how one unit (WayUnits) of each deviation changes the missing flows. A
/// leak of k_l P past the piston acts as extra flow into the cylinder.
void set_slopes(NoisyRows& rows, const Balance& balance, const MovementSamples& movement, std::size_t junction,
                const MatrixXd& by_flow) {
    const WayUnits& unit = balance.unit(junction);
    const auto height = static_cast<Eigen::Index>(balance.junctions());
    for (Eigen::Index i = 0; i < by_flow.cols(); ++i) {
        const JunctionSamples& samples = movement.moving[static_cast<std::size_t>(i)];
        const LinkSample& link = samples[junction];
        auto block = rows.slopes.block(i * height, row_of(junction), height, ways);
        block.col(0) = by_flow.col(i) * (link.inlet_slope_psi_per_s * unit.compliance_in3_per_psi);
        block.col(1) = by_flow.col(i) * (link.inlet_psi * unit.leak_in3_per_s_psi);
        if (!balance.reads_areas(junction))
            block.col(2) = balance.by_offset(samples, junction) * unit.offset_in;
    }
}

/// Adds the columns and the noise of one link. Returns the noise in the column of its compliance.
Sparse add_link(NoisyRows& rows, const Balance& balance, const MovementSamples& movement, std::size_t junction,
                const ReadingNoise& noise) {
    const MatrixXd by_flow = by_sample(movement, balance.junctions(), [&](const JunctionSamples& samples) {
        return balance.by_flow(samples, junction);
    });
    const MatrixXd by_pressure = by_sample(movement, balance.junctions(), [&](const JunctionSamples& samples) {
        return balance.by_pressure(samples, junction);
    });
    set_slopes(rows, balance, movement, junction, by_flow);
    const Sparse of_slopes = slope_noise(noise.slope_psi_per_s * by_flow);
    rows.add_noise(balance.compliance(junction) * of_slopes + white_noise(noise.psi * by_pressure));
    rows.add_noise(slope_noise(noise.flow_in3_per_s * by_flow));
    add_valve_noise(rows, balance, movement, junction, noise);
    return balance.unit(junction).compliance_in3_per_psi * of_slopes;
}

MovingRows moving_rows(const Balance& balance, const MovementSamples& movement,
                       const std::vector<ReadingNoise>& noises) {
    const auto height = static_cast<Eigen::Index>(balance.junctions());
    const auto count = static_cast<Eigen::Index>(movement.moving.size());
    MovingRows moving{NoisyRows(height * count, balance.unknowns(), least_variance_moving), {}};
    moving.rows.missed = by_sample(movement, balance.junctions(), [&](const JunctionSamples& each) {
                             return balance.missed(each);
                         }).reshaped();
    for (std::size_t j = 0; j < balance.junctions(); ++j)
        moving.compliance_noise.push_back(add_link(moving.rows, balance, movement, j, noises[j]));
    return moving;
}

/// Returns the equations of one link at rest. Its inlet is shut, so A v + C dP/dt + k_l P = 0, whatever the spool's
/// reading is. These equations alone determine only the ratio of leak and compliance. Therefore the compliance at rest
/// is assumed to equal the compliance during the movement, within compliance_at_rest_within.
NoisyRows rows_at_rest(const Balance& balance, const std::vector<JunctionSamples>& samples, std::size_t junction,
                       FaultHypothesis leak, const ReadingNoise& noise) {
    const Eigen::Index column = row_of(junction);
    const auto count = static_cast<Eigen::Index>(samples.size());
    const WayUnits& unit = balance.unit(junction);
    const double compliance = balance.compliance(junction);
    NoisyRows rows(count, balance.unknowns(), least_variance_at_rest);
    for (Eigen::Index i = 0; i < count; ++i) {
        const LinkSample& link = samples[static_cast<std::size_t>(i)][junction];
        rows.slopes(i, column) = -link.inlet_slope_psi_per_s * unit.compliance_in3_per_psi;
        rows.slopes(i, column + row_of(leak)) = -link.inlet_psi * unit.leak_in3_per_s_psi;
        rows.missed[i] = -cylinder_flow(link.piston_flow_in3_per_s, link.inlet_slope_psi_per_s, compliance);
    }
    rows.add_noise(MatrixXd(compliance_at_rest_within * rows.slopes.col(column)).sparseView());
    const MatrixXd same = MatrixXd::Constant(1, count, 1);
    rows.add_noise(slope_noise(compliance * noise.slope_psi_per_s * same));
    rows.add_noise(slope_noise(noise.flow_in3_per_s * same));
    return rows;
}

/// The normal equations of the least-squares fit to a movement.
struct Equations {
    MatrixXd information; ///< includes the part that is noise
    VectorXd pull;
    VectorXd noise;     ///< the part of each unknown's information that is noise
    VectorXd in_health; ///< for each unknown, the healthy value in the units of WayUnits, since noise biases the sum of
                        ///< healthy value and deviation
};

/// Returns the equations before any sample is added: each deviation is 0 with standard deviation `prior_units`.
Equations before_movement(Eigen::Index unknowns) {
    const VectorXd none = VectorXd::Zero(unknowns);
    return {MatrixXd::Identity(unknowns, unknowns) / (prior_units * prior_units), none, none, none};
}

/// Adds the samples during the movement, and returns MovementFit::misfit. Also stores the part of the information that
/// comes only from the noise of the slopes. solve() removes this part; otherwise the compliance would be too small
/// (errors in variables).
double add_moving(Equations& equations, const MovingRows& moving) {
    const Weights weights(moving.rows);
    const MatrixXd information = weights.information();
    VectorXd noise = VectorXd::Zero(information.rows());
    for (std::size_t j = 0; j < moving.compliance_noise.size(); ++j) {
        noise[row_of(j)] = weights.share_of(moving.compliance_noise[j]);
        equations.in_health[row_of(j)] = 1 / WayUnits::compliance_share;
    }
    MatrixXd without_noise = equations.information + information;
    without_noise.diagonal() -= noise;
    const VectorXd by = without_noise.ldlt().solve(weights.pull() + noise.cwiseProduct(equations.in_health));
    const double scale = weights.scale(by, without_noise.rows());
    equations.information += information / scale;
    equations.pull += weights.pull() / scale;
    equations.noise = noise / scale;
    return scale;
}

/// Adds the uncertainty `leak_by_flow_within` to the leak found from the flow during the movement, since an offset may
/// explain the flow as well.
void limit_leak(Equations& equations, Eigen::Index leak) {
    MatrixXd information = equations.information;
    information.diagonal() -= equations.noise;
    const MatrixXd covariance = information.inverse();
    const VectorXd by = covariance * (equations.pull + equations.noise.cwiseProduct(equations.in_health));
    const double known = 1 / covariance(leak, leak);
    if (!(known > 0)) // the slopes are hardly more than noise, which solve() detects
        return;
    const double too_much = known * known / (known + 1 / (leak_by_flow_within * leak_by_flow_within));
    equations.information(leak, leak) -= too_much;
    equations.pull[leak] -= too_much * by[leak];
}

/// Adds the information of the samples at rest about the leak, given the compliance. The samples at rest say nothing
/// about the compliance itself, because their slopes are mostly noise.
void add_rest(Equations& equations, const NoisyRows& rest, Eigen::Index leak) {
    const Weights weights(rest);
    const double known = weights.information()(leak, leak);
    if (known == 0) // without pressure, samples at rest say nothing about a leak
        return;
    VectorXd by = VectorXd::Zero(equations.pull.size());
    by[leak] = weights.pull()[leak] / known;
    const double scale = weights.scale(by, 1);
    const VectorXd told = weights.information().col(leak) / known;
    equations.information += known / scale * told * told.transpose();
    equations.pull += weights.pull()[leak] / scale * told;
}

std::vector<Deviation> parts(const VectorXd& by, const MatrixXd& covariance) {
    std::vector<Deviation> deviations;
    for (Eigen::Index first = 0; first < by.size(); first += ways)
        deviations.push_back(
            {ways_of(by.segment<ways>(first)), two_ways_of(covariance.block<ways, ways>(first, first))});
    return deviations;
}

std::optional<std::vector<Deviation>> solve(const Equations& equations) {
    MatrixXd information = equations.information;
    information.diagonal() -= equations.noise;
    if (information.llt().info() != Eigen::Success)
        return std::nullopt;
    const MatrixXd inverse = information.inverse();
    const VectorXd by = inverse * (equations.pull + equations.noise.cwiseProduct(equations.in_health));
    const VectorXd unsure = noise_known_within * equations.noise.cwiseProduct(equations.in_health + by);
    MatrixXd pulls = equations.information;
    pulls.diagonal() += unsure.cwiseProduct(unsure);
    return parts(by, inverse * pulls * inverse);
}

/// Adds the uncertainty `leak_after_within` to the leak found from the rest after the movement, and to the deviations
/// correlated with this leak.
void add_unread_pressure(Deviation& deviation) {
    const Eigen::Index leak = row_of(FaultHypothesis::leak);
    WayMatrix covariance = matrix_of(deviation.covariance);
    const WayVector with_leak = covariance.col(leak) / covariance(leak, leak);
    const double error = leak_after_within * deviation.by[index_of(FaultHypothesis::leak)];
    covariance += error * error * with_leak * with_leak.transpose();
    deviation.covariance = two_ways_of(covariance);
}

} // namespace

std::optional<MovementFit> fit_movement(const Circuit& circuit, const FlowConstants& flow,
                                        std::span<const LinkInHealth> links, const MovementSamples& movement) {
    if (movement.moving.size() < fewest_moving)
        return std::nullopt;
    const Balance balance(circuit, flow, links);
    std::vector<ReadingNoise> noises;
    for (std::size_t j = 0; j < circuit.size(); ++j)
        noises.push_back(reading_noise(movement, j));
    Equations equations = before_movement(balance.unknowns());
    const double misfit = add_moving(equations, moving_rows(balance, movement, noises));
    for (std::size_t j = 0; j < circuit.size(); ++j)
        if (!balance.reads_areas(j))
            limit_leak(equations, row_of(j) + row_of(FaultHypothesis::leak));
    auto add_rests = [&](const std::vector<JunctionSamples>& samples, FaultHypothesis leak) {
        for (std::size_t j = 0; j < circuit.size(); ++j)
            add_rest(equations, rows_at_rest(balance, samples, j, leak, noises[j]), row_of(j) + row_of(leak));
    };
    const bool rest_before = movement.at_rest.size() >= fewest_at_rest,
               rest_after = rest_before && movement.rest_after.size() >= fewest_at_rest;
    if (rest_before)
        add_rests(movement.at_rest, FaultHypothesis::leak_before);
    if (rest_after)
        add_rests(movement.rest_after, FaultHypothesis::leak);
    auto found = solve(equations);
    if (getenv("DBG"))
        fprintf(stderr, "misfit %g found %d\n", misfit, (int)found.has_value());
    if (!found)
        return std::nullopt;
    if (rest_after)
        std::ranges::for_each(*found, add_unread_pressure);
    return MovementFit{std::move(*found), misfit};
}

} // namespace placedpar::identification
