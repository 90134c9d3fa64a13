#include "experiments/chapter_3/study.hpp"

#include "experiments/kit/cells.hpp"
#include "hydraulics/data/units.hpp"
#include "hydraulics/plant/boom_record.hpp"
#include "identification/compliance_fit.hpp"
#include "runtime/random.hpp"

#include <algorithm>
#include <cmath>

namespace placedpar {

using namespace hydraulics;

namespace {

constexpr double m3_per_in3 = metre_per_inch * metre_per_inch * metre_per_inch;
constexpr double m2_per_in2 = metre_per_inch * metre_per_inch;
constexpr double m3_per_pascal = m3_per_in3 / pascal_per_psi; // compliance

FlowConstants in_si(const FlowConstants& flow) {
    FlowConstants si = flow;
    si.orifice_in3_per_s_in2_sqrt_psi *= m3_per_in3 / (m2_per_in2 * std::sqrt(pascal_per_psi));
    si.pump_in3_per_s *= m3_per_in3;
    si.tank_psi *= pascal_per_psi;
    si.relief_psi *= pascal_per_psi;
    return si;
}

std::vector<CircuitSample> in_si(std::span<const CircuitSample> samples) {
    std::vector<CircuitSample> si(samples.begin(), samples.end());
    for (CircuitSample& sample : si)
        for (LinkSample& link : sample.links)
            link = {link.inlet_psi * pascal_per_psi, link.inlet_slope_psi_per_s * pascal_per_psi,
                    link.piston_flow_in3_per_s * m3_per_in3, link.inlet_in2 * m2_per_in2, link.bypass_in2 * m2_per_in2};
    return si;
}

/// The best of all codes with every number in SI units: the equations know no units, but for B, which goes with the
/// flow's.
double optimum_code_in_si(std::span<const CircuitSample> window, const FlowConstants& flow,
                          const IdentificationWay& way) {
    auto optimum = exhaustive_optimum(boom_circuit(), in_si(window), in_si(flow), printed_inlet_flow(1), way.bits,
                                      CircuitProblem::largest_in3_per_psi * m3_per_pascal,
                                      way.search.window.bias * m3_per_in3 * m3_per_in3);
    return static_cast<double>(optimum.codes[0]);
}

void add(Study& study, const Transients& transients, std::span<const CircuitSample> samples,
         const IdentificationWay& way, std::uint64_t seed) {
    CircuitProblem problem(boom_circuit(), transients.flow, way.bits);
    Identified found = identify(problem, transients.flow, samples, way, seed);
    const LinkIdentified& boom = found.links.front();
    study.error_percent.push_back(100 * std::abs(boom.compliance_in3_per_psi / transients.true_in3_per_psi - 1));
    if (!boom.optimum)
        return;
    study.codes_from_optimum.push_back(*boom.codes_from_optimum);
    auto window = samples.last(std::min(samples.size(), way.search.window.length));
    double code = std::round(*boom.optimum / problem.field().resolution());
    study.si_codes.push_back(std::abs(optimum_code_in_si(window, transients.flow, way) - code));
}

} // namespace

double Study::median_percent() const { return median(error_percent); }
double Study::ninetieth_percent() const { return share_below(error_percent, 0.9); }
double Study::within_ten_percent() const { return percent_within(error_percent, 10); }

Transients measure_transients(const MeasurementNoise& noise, const UsableSamples& usable,
                              std::span<const std::uint64_t> seeds) {
    BoomScenario scenario;
    Circuit circuit = boom_circuit();
    auto motion = simulate_boom(scenario);
    Transients transients{scenario.machine.inlet_compliance_in3_per_psi, scenario.flow, {}};
    for (std::uint64_t seed : seeds) {
        RandomStream sensors(seed, "sensors");
        Record record = measure_boom(motion, scenario.machine.moment_arm_in, sampling_period_s, noise,
                                     [&] { return sensors.uniform(); });
        auto samples = circuit_samples(record, circuit, boom_readings(scenario.machine));
        transients.samples.push_back(usable_samples(samples, circuit, scenario.flow, usable));
    }
    return transients;
}

Study study(const Transients& transients, const IdentificationWay& way, std::span<const std::uint64_t> seeds) {
    Study result;
    for (std::size_t i = 0; i < transients.samples.size(); ++i)
        add(result, transients, transients.samples[i], way, seeds[i]);
    return result;
}

} // namespace placedpar
