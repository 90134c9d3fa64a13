#include "identification/verdict/deviation.hpp"

#include "hydraulics/circuit/boom_orifices.hpp"
#include "hydraulics/circuit/circuit_error.hpp"
#include "identification/verdict/noisy_rows.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace placedpar::identification {

using namespace hydraulics;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr Eigen::Index ways = all_ways.size();
constexpr std::size_t fewest_at_rest = 4;
/// (in^3/s)^2 of each sample, beyond the noise of the sensors: of the equations; at rest of a converter and of
/// friction.
constexpr double least_variance_moving = 0.001, least_variance_at_rest = 0.05;
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

/// The equations of a circuit near health: by how much a sample's flows fail to balance, a row a junction, and what
/// changes that.
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
    /// What one more in^3/s into the cylinder changes, one more psi, one more in^2.
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
    /// What a reading of the spool that is too high by one inch changes: it stands lower.
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

/// Standard deviations of what is read of a link.
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

/// Of every moving sample a column: what changes the flows that are missed at all junctions.
template <class Change>
MatrixXd by_sample(const MovementSamples& movement, std::size_t junctions, const Change& change) {
    MatrixXd columns(static_cast<Eigen::Index>(junctions), static_cast<Eigen::Index>(movement.moving.size()));
    for (Eigen::Index i = 0; i < columns.cols(); ++i)
        columns.col(i) = change(movement.moving[static_cast<std::size_t>(i)]);
    return columns;
}

/// A movement's rows, sample by sample, and of each link the noise of its compliance's column.
struct MovingRows {
    NoisyRows rows;
    std::vector<Sparse> compliance_noise;
};

/// The white noise of a link's valve, in what is missed.
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

/// The columns of a link: what a unit of each way changes. A leak past the piston takes k_l P, as though the piston
/// took more.
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

/// One link's columns and noise; the noise of its compliance's column.
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

/// At rest the inlet is shut: A v + C dP/dt + k_l P = 0, whatever the spool reads.
NoisyRows rows_at_rest(const Balance& balance, const MovementSamples& movement, std::size_t junction,
                       const ReadingNoise& noise) {
    const auto count = static_cast<Eigen::Index>(movement.at_rest.size());
    const WayUnits& unit = balance.unit(junction);
    const double compliance = balance.compliance(junction);
    NoisyRows rows(count, balance.unknowns(), least_variance_at_rest);
    for (Eigen::Index i = 0; i < count; ++i) {
        const LinkSample& link = movement.at_rest[static_cast<std::size_t>(i)][junction];
        rows.slopes(i, row_of(junction)) = -link.inlet_slope_psi_per_s * unit.compliance_in3_per_psi;
        rows.slopes(i, row_of(junction) + 1) = -link.inlet_psi * unit.leak_in3_per_s_psi;
        rows.missed[i] = -cylinder_flow(link.piston_flow_in3_per_s, link.inlet_slope_psi_per_s, compliance);
    }
    const MatrixXd same = MatrixXd::Constant(1, count, 1);
    rows.add_noise(slope_noise(compliance * noise.slope_psi_per_s * same));
    rows.add_noise(slope_noise(noise.flow_in3_per_s * same));
    return rows;
}

/// The normal equations of a movement.
struct Equations {
    MatrixXd information; ///< noise included
    VectorXd pull;
    VectorXd noise;     ///< what is noise of each unknown's information
    VectorXd in_health; ///< of each unknown, what it is in health, in its unit: the noise spoils all of it

    void add(const MatrixXd& more, const VectorXd& pulls) {
        information += more;
        pull += pulls;
    }
};

/// Nothing is known but that a link is hardly off by more than prior_units.
Equations before_movement(Eigen::Index unknowns) {
    const VectorXd none = VectorXd::Zero(unknowns);
    return {MatrixXd::Identity(unknowns, unknowns) / (prior_units * prior_units), none, none, none};
}

/// The noise of the slopes adds to the information of a compliance, which would come out too small by it (errors in
/// variables).
void add_moving(Equations& equations, const MovingRows& moving) {
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
    equations.add(information / scale, weights.pull() / scale);
    equations.noise = noise / scale;
}

void add_rest(Equations& equations, const NoisyRows& rest, std::size_t junction) {
    const Weights weights(rest);
    const Eigen::Index leak = row_of(junction) + 1; // nothing else is told apart there
    if (weights.information()(leak, leak) == 0)     // nor a leak, without pressure
        return;
    VectorXd by = VectorXd::Zero(equations.pull.size());
    by[leak] = weights.pull()[leak] / weights.information()(leak, leak);
    const double scale = weights.scale(by, 1);
    equations.add(weights.information() / scale, weights.pull() / scale);
}

std::vector<Deviation> parts(const VectorXd& by, const MatrixXd& covariance) {
    std::vector<Deviation> deviations;
    for (Eigen::Index first = 0; first < by.size(); first += ways)
        deviations.push_back({by.segment<ways>(first), covariance.block<ways, ways>(first, first)});
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
    const Balance balance(circuit, flow, links);
    std::vector<ReadingNoise> noises;
    for (std::size_t j = 0; j < circuit.size(); ++j)
        noises.push_back(reading_noise(movement, j));
    Equations equations = before_movement(balance.unknowns());
    add_moving(equations, moving_rows(balance, movement, noises));
    if (movement.at_rest.size() >= fewest_at_rest)
        for (std::size_t j = 0; j < circuit.size(); ++j)
            add_rest(equations, rows_at_rest(balance, movement, j, noises[j]), j);
    return solve(equations);
}

} // namespace placedpar::identification
