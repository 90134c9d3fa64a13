#include "experiments/chapter_3/kit/two_link_study.hpp"

#include "hydraulics/plant/excavator_record.hpp"
#include "hydraulics/plant/excavator_values.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace placedpar {

using namespace hydraulics;
using namespace identification;

namespace {

const LinkSet bucket_and_boom{Link::bucket, Link::boom};

} // namespace

TwoLinkMotion simulate_two_links() {
    ExcavatorScenario scenario = two_link_scenario();
    return {scenario, simulate_excavator(scenario), link_calibrations(Parameters::excavator())};
}

ComplianceSearch measure_two_links(const TwoLinkMotion& motion, const MeasurementNoise& noise,
                                   const IdentificationWay& way, std::uint64_t seed) {
    RandomStream sensors(seed, "sensors");
    Record record =
        measure_excavator(motion.motion, motion.scenario, sampling_period_s, noise, [&] { return sensors.uniform(); });
    return prepare(record, Parameters::excavator(), {Configuration::a, bucket_and_boom, {}}, way);
}

TwoErrors errors_of(std::span<const double> compliance_in3_per_psi) {
    auto error = [&](std::size_t junction, const char* name) {
        return 100 * std::abs(compliance_in3_per_psi[junction] / Parameters::excavator()[name] - 1);
    };
    return {error(0, "bucket.inlet_compliance"), error(1, "boom.inlet_compliance")};
}

IdentificationWay elite_way() {
    IdentificationWay way = thesis_way();
    way.search.elite = 1;
    way.usable.skipped = 2;
    return way;
}

IdentificationWay gray_way() {
    IdentificationWay way = elite_way();
    way.coding = Coding::gray;
    return way;
}

TwoLinkSearch search_two_links(const TwoLinkMotion& motion, const MeasurementNoise& noise, const IdentificationWay& way,
                               std::uint64_t seed) {
    ComplianceSearch prepared = measure_two_links(motion, noise, way, seed);
    SearchRun run = search_transient(prepared.problem, prepared.samples, way, RandomStream(seed, "master"));
    return {std::move(prepared), std::move(run)};
}

std::vector<SearchRun> search_many(const TwoLinkMotion& motion, const MeasurementNoise& noise,
                                   const IdentificationWay& way, std::span<const std::uint64_t> seeds) {
    std::vector<SearchRun> runs;
    for (std::uint64_t seed : seeds)
        runs.push_back(search_two_links(motion, noise, way, seed).run);
    return runs;
}

/// Returns the errors after this generation, or at the end of the run if the run has fewer generations.
static TwoErrors errors_after(const SearchRun& run, std::size_t generation, std::size_t trials) {
    std::size_t estimate = std::min(generation / trials, run.estimates.size());
    return errors_of(run.estimates[estimate - 1].compliance_in3_per_psi);
}

double both_within_ten_percent(std::span<const SearchRun> runs, std::size_t generation, std::size_t trials) {
    auto within = std::ranges::count_if(
        runs, [&](const SearchRun& run) { return errors_after(run, generation, trials).both_within(10); });
    return 100 * static_cast<double>(within) / static_cast<double>(runs.size());
}

InternalStates true_states(const ExcavatorState& state) {
    const JunctionFlow &bucket = state.links[0].flow, &boom = state.links[1].flow;
    return {bucket.psi,          boom.psi, bucket.bypass_in3_per_s, boom.bypass_in3_per_s, bucket.inlet_in3_per_s,
            boom.inlet_in3_per_s};
}

InternalStates estimated_states(const CircuitSample& sample, std::span<const double> compliance_in3_per_psi,
                                const FlowConstants& flow) {
    std::array<double, 2> inlet{}, psi{};
    for (std::size_t j = 0; j < 2; ++j) {
        const LinkSample& link = sample.links[j];
        inlet[j] = cylinder_flow(link.piston_flow_in3_per_s, link.inlet_slope_psi_per_s, compliance_in3_per_psi[j]);
        psi[j] = junction_pressure(flow.conductance(link.inlet_in2), link.inlet_psi, inlet[j]);
    }
    auto past = [&](std::size_t j, double next_psi) {
        return bypass_flow(flow.conductance(sample.links[j].bypass_in2), psi[j] - next_psi);
    };
    return {psi[0], psi[1], past(0, psi[1]), past(1, flow.tank_psi), inlet[0], inlet[1]};
}

} // namespace placedpar
