#include "experiments/chapter_3/kit/study.hpp"

#include "hydraulics/data/units.hpp"
#include "hydraulics/plant/excavator_record.hpp"
#include "hydraulics/plant/excavator_values.hpp"
#include "identification/compliance_fit.hpp"
#include "runtime/random.hpp"
#include "text/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace placedpar {

using namespace hydraulics;
using namespace identification;

namespace {

constexpr double m3_per_in3 = metre_per_inch * metre_per_inch * metre_per_inch;
constexpr double m2_per_in2 = metre_per_inch * metre_per_inch;
constexpr double m3_per_pascal = m3_per_in3 / pascal_per_psi; // for compliances

/// The flow constants and a sample of the boom in SI units.
struct SiFlow {
    double orifice_m3_per_s_m2_sqrt_pa, pump_m3_per_s, tank_pa;
};
struct SiSample {
    double inlet_pa, inlet_slope_pa_per_s, piston_flow_m3_per_s, inlet_m2, bypass_m2;
};

SiFlow in_si(const FlowConstants& flow) {
    return {flow.orifice_in3_per_s_in2_sqrt_psi * (m3_per_in3 / (m2_per_in2 * std::sqrt(pascal_per_psi))),
            flow.pump_in3_per_s * m3_per_in3, flow.tank_psi * pascal_per_psi};
}

SiSample in_si(const LinkSample& link) {
    return {link.inlet_psi * pascal_per_psi, link.inlet_slope_psi_per_s * pascal_per_psi,
            link.piston_flow_in3_per_s * m3_per_in3, link.inlet_in2 * m2_per_in2, link.bypass_in2 * m2_per_in2};
}

/// Returns the error of equation 3.8, in m^3/s.
double error_in_si(const SiFlow& flow, const SiSample& sample, double compliance_m3_per_pa) {
    double k = flow.orifice_m3_per_s_m2_sqrt_pa;
    double inlet = cylinder_flow(sample.piston_flow_m3_per_s, sample.inlet_slope_pa_per_s, compliance_m3_per_pa);
    double junction_pa = junction_pressure(k * sample.inlet_m2, sample.inlet_pa, inlet);
    return flow.pump_m3_per_s - std::abs(inlet) - bypass_flow(k * sample.bypass_m2, junction_pa - flow.tank_pa);
}

/// Returns the best of all codes, computed with all values in SI units. The equations hold in any units, but the
/// bias of the fitness is converted, since its unit is the square of the flow's unit.
double optimum_code_in_si(std::span<const CircuitSample> window, const FlowConstants& flow,
                          const IdentificationWay& way) {
    const SiFlow si_flow = in_si(flow);
    std::vector<SiSample> samples;
    for (const CircuitSample& sample : window)
        samples.push_back(in_si(sample.links.front()));
    const double largest_m3_per_pa = CircuitProblem::largest_in3_per_psi * m3_per_pascal;
    const double bias = way.search.window.bias * m3_per_in3 * m3_per_in3;
    double best = 0, greatest = -std::numeric_limits<double>::infinity();
    const double codes = std::exp2(way.bits);
    for (double code = 0; code < codes; ++code) {
        double fitness = 0;
        for (const SiSample& sample : samples) {
            double error = error_in_si(si_flow, sample, largest_m3_per_pa * code / codes);
            fitness += bias - error * error;
        }
        if (fitness > greatest) {
            greatest = fitness;
            best = code;
        }
    }
    return best;
}

void add(SearchStudy& study, const Transients& transients, std::span<const CircuitSample> samples,
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

double SearchStudy::median_percent() const { return lower_median(error_percent); }
double SearchStudy::ninetieth_percent() const { return quantile(error_percent, 0.9); }
double SearchStudy::within_ten_percent() const { return percent_within(error_percent, 10); }

Transients measure_transients(const MeasurementNoise& noise, const UsableSamples& usable,
                              std::span<const std::uint64_t> seeds) {
    ExcavatorScenario scenario = single_boom_scenario();
    const LinkMechanics& boom = scenario.links.front().mechanics;
    Circuit circuit = boom_circuit();
    auto motion = simulate_excavator(scenario);
    Transients transients{boom.inlet_compliance_in3_per_psi, scenario.flow, {}};
    for (std::uint64_t seed : seeds) {
        RandomStream sensors(seed, "sensors");
        Record record =
            measure_excavator(motion, scenario, sampling_period_s, noise, [&] { return sensors.uniform(); });
        auto samples = circuit_samples(record, circuit, boom_calibrations(boom));
        transients.samples.push_back(usable_samples(samples, circuit, scenario.flow, usable));
    }
    return transients;
}

SearchStudy study(const Transients& transients, const IdentificationWay& way, std::span<const std::uint64_t> seeds) {
    SearchStudy result;
    for (std::size_t i = 0; i < transients.samples.size(); ++i)
        add(result, transients, transients.samples[i], way, seeds[i]);
    return result;
}

} // namespace placedpar
