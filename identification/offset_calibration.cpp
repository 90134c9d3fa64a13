#include "identification/offset_calibration.hpp"

#include "hydraulics/circuit/boom_orifices.hpp"
#include "hydraulics/circuit/voltage_spool.hpp"

#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace placedpar::identification {

using namespace hydraulics;

namespace {

/// A sample of steady motion. The flow is assumed to be right; the spool's reading may be wrong.
struct SteadySample {
    double inlet_psi, piston_flow_in3_per_s, spool_in;
};

/// Returns by how much the pump's flow exceeds the flows to the cylinder and to the tank, if the true spool position is
/// the reading minus the offset. With a greater offset, the spool position is smaller and the bypass is wider open, so
/// the result is smaller.
double missing_in3_per_s(const SteadySample& sample, double offset_in, const FlowConstants& flow) {
    OrificeAreas areas = boom_orifices(std::max(sample.spool_in - offset_in, boom_dead_band_in + 1e-4));
    double pump_psi =
        junction_pressure(flow.conductance(areas.inlet_in2), sample.inlet_psi, sample.piston_flow_in3_per_s);
    double drop_psi = std::min(pump_psi, flow.relief_psi) - flow.tank_psi;
    return flow.pump_in3_per_s - sample.piston_flow_in3_per_s -
           bypass_flow(flow.conductance(areas.bypass_in2), drop_psi);
}

double mean_missing(std::span<const SteadySample> samples, double offset_in, const FlowConstants& flow) {
    double sum = 0;
    for (const SteadySample& sample : samples)
        sum += missing_in3_per_s(sample, offset_in, flow);
    return sum / static_cast<double>(samples.size());
}

/// Returns the rms slope of the pressure; infinite if the motion is not steady.
double unrest_psi_per_s(std::span<const CircuitSample> samples, const SteadyMotion& steady) {
    constexpr double never = std::numeric_limits<double>::infinity();
    double squares = 0, halves_psi = 0; // sum of the pressures in the second half minus the sum in the first half
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const LinkSample& link = samples[i].links[0];
        if (link.piston_flow_in3_per_s < steady.least_flow_in3_per_s)
            return never;
        squares += link.inlet_slope_psi_per_s * link.inlet_slope_psi_per_s;
        halves_psi += 2 * i < samples.size() ? -link.inlet_psi : link.inlet_psi;
    }
    auto count = static_cast<double>(samples.size());
    double unrest = std::sqrt(squares / count);
    return unrest > steady.slope_psi_per_s || std::abs(2 * halves_psi / count) > steady.drift_psi ? never : unrest;
}

/// Returns the position of the spool at each instant: as read, or computed from the voltage by equation A.1.
std::vector<double> boom_spool(const Record& record, const LinkCalibration& boom) {
    return boom.from == AreasFrom::servo ? spool_from_volts(record.of(Link::boom, Sensor::servo), record.time_s,
                                                            boom.constants.spool_lag_per_s, record.period_s)
                                         : record.of(Link::boom, Sensor::spool);
}

std::vector<SteadySample> steadiest_motion(const Record& record, const LinkCalibrations& calibrations,
                                           const SteadyMotion& steady) {
    auto samples = circuit_samples(record, boom_circuit(), calibrations);
    auto length = 2 * static_cast<std::size_t>(std::lround(steady.duration_s / record.period_s / 2));
    double least = std::numeric_limits<double>::infinity();
    std::span<const CircuitSample> best;
    for (std::size_t first = 0; length > 0 && first + length <= samples.size(); ++first) {
        auto stretch = std::span<const CircuitSample>(samples).subspan(first, length);
        bool whole = stretch.back().index - stretch.front().index == length - 1;
        if (double unrest = unrest_psi_per_s(stretch, steady); whole && unrest < least) {
            least = unrest;
            best = stretch;
        }
    }
    const std::vector<double> spool_in = boom_spool(record, calibrations[index_of(Link::boom)]);
    std::vector<SteadySample> motion;
    for (const CircuitSample& sample : best)
        motion.push_back({sample.links[0].inlet_psi, sample.links[0].piston_flow_in3_per_s, spool_in[sample.index]});
    return motion;
}

/// Returns the standard error of the offset. Each sample alone gives an offset, by one Newton step from `offset_in`.
/// The result is the standard error of the mean of these offsets.
double standard_error(std::span<const SteadySample> samples, double offset_in, const FlowConstants& flow) {
    constexpr double step_in = 1e-4;
    double sum = 0, squares = 0;
    for (const SteadySample& sample : samples) {
        double slope = (missing_in3_per_s(sample, offset_in + step_in, flow) -
                        missing_in3_per_s(sample, offset_in - step_in, flow)) /
                       (2 * step_in);
        double own = missing_in3_per_s(sample, offset_in, flow) / slope;
        sum += own;
        squares += own * own;
    }
    auto count = static_cast<double>(samples.size());
    return std::sqrt((squares - sum * sum / count) / (count - 1) / count);
}

} // namespace

std::optional<SpoolOffset> calibrate_spool_offset(const Record& record, const LinkCalibrations& calibrations,
                                                  const FlowConstants& flow, const SteadyMotion& steady) {
    LinkCalibrations as_read = calibrations;
    as_read[index_of(Link::boom)].spool_offset_in = 0;
    auto samples = steadiest_motion(record, as_read, steady);
    if (samples.empty())
        return std::nullopt;
    auto missing = [&](double offset_in) { return mean_missing(samples, offset_in, flow); };
    if (missing(-greatest_spool_offset_in) * missing(greatest_spool_offset_in) > 0)
        return std::nullopt;
    std::uintmax_t iterations = 100;
    auto [low, high] = boost::math::tools::toms748_solve(missing, -greatest_spool_offset_in, greatest_spool_offset_in,
                                                         boost::math::tools::eps_tolerance<double>(40), iterations);
    double offset = (low + high) / 2;
    return SpoolOffset{offset, standard_error(samples, offset, flow), samples.size()};
}

} // namespace placedpar::identification
