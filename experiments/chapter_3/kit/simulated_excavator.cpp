#include "experiments/chapter_3/kit/simulated_excavator.hpp"

#include "hydraulics/plant/record_scenario.hpp"
#include "identification/on_line/record_samples.hpp"
#include "runtime/random.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

namespace placedpar {

using namespace hydraulics;
using namespace identification;

namespace {

/// A parameter and its largest relative deviation.
using Scatter = std::pair<const char*, double>;

constexpr Scatter machine_scatter[]{
    {"boom.inlet_compliance", 0.1}, {"boom.outlet_compliance", 0.2},  {"boom.friction", 0.2}, {"boom.damping", 0.2},
    {"boom.gravity", 0.1},          {"bucket.inlet_compliance", 0.1}, {"bucket.gravity", 0.1}};
constexpr Scatter movement_scatter[]{{"boom.gravity", 0.05}, {"bucket.gravity", 0.05}};

bool moves_two(const RecordSource& source) { return record_scenario_named(source.scenario)->any_links; }

/// Throws std::invalid_argument if the scenario's records lack the readings of the valve that `from` needs.
void require_readings(const RecordSource& source, AreasFrom from) {
    const char* name = from == AreasFrom::areas ? "areas" : from == AreasFrom::spool ? "spool" : "voltage";
    const bool there = from == AreasFrom::areas ? moves_two(source)
                                                : !moves_two(source) && (from == AreasFrom::spool || source.has_servo);
    if (!there)
        throw std::invalid_argument(fmt::format("{} does not record the {} of a valve", source.scenario, name));
}

double uniform(RandomStream& random, double low, double high) { return low + (high - low) * random.uniform(); }

void scatter(Parameters& parameters, std::span<const Scatter> by, RandomStream& random) {
    for (const auto& [name, share] : by)
        parameters.set(name, parameters[name] * uniform(random, 1 - share, 1 + share));
}

/// Sets the operator's command, which is drawn at random. The valve opens for 60 to 140 % of the thesis's flow. Opening
/// takes 0 to 0.3 s. With a servo-valve, the valve shuts after 1 to 2.5 s; without a servo-valve, the record ends after
/// this time. The scenario for two links has its own controller, which opens both valves at once.
void command(Parameters& parameters, const RecordSource& source, RandomStream& random) {
    const double opened = random.uniform(), ramp_s = uniform(random, 0, 0.3), for_s = uniform(random, 1, 2.5);
    if (source.has_servo) {
        parameters.set("excavator.servo_desired", 0.28 + 0.12 * opened);
        parameters.set("excavator.servo_ramp", ramp_s);
        parameters.set("excavator.second_time", for_s + 0.1);
        parameters.set("excavator.duration", for_s + 0.8);
        parameters.set("excavator.integration_step", 0.0002); // saves half of the work; 0.0004 would be refused
    } else if (moves_two(source)) {
        parameters.set("controller.asked_flow", 30 + 40 * opened);
        parameters.set("two_links.duration", for_s);
    } else {
        parameters.set("scenario_a.spool_desired", 0.24 + 0.04 * opened);
        parameters.set("scenario_a.spool_ramp", ramp_s);
        parameters.set("scenario_a.duration", for_s + 0.1);
    }
}

Parameters parameters_of(const RecordSource& source, std::uint64_t seed) {
    Parameters parameters = record_scenario_named(source.scenario)->parameters(Parameters::excavator());
    RandomStream random(seed, "machine");
    scatter(parameters, machine_scatter, random);
    for (Parameter& row : noise_rows(parameters, source.noise))
        parameters.put(std::move(row));
    parameters.set("sensors.period", source.period_s);
    return parameters;
}

/// Makes the integration steps of the motion at most as long as the sensors' period.
void shorten_steps(Parameters& parameters, double period_s) {
    for (const char* step : {"excavator.integration_step", "scenario_a.integration_step"})
        parameters.set(step, std::min(parameters[step], period_s));
}

} // namespace

SimulatedExcavator::SimulatedExcavator(const RecordSource& source, AreasFrom from, std::uint64_t seed)
    : source_(source), from_(from), seed_(seed), parameters_(parameters_of(source, seed)) {
    require_readings(source, from);
}

LinkSet SimulatedExcavator::links() const {
    return moves_two(source_) ? LinkSet{Link::bucket, Link::boom} : LinkSet{Link::boom};
}

Record SimulatedExcavator::movement(const PlantFault& fault, double compliance_factor, std::uint64_t number) const {
    Parameters parameters = parameters_;
    RandomStream random(seed_, fmt::format("movement/{}", number));
    scatter(parameters, movement_scatter, random);
    command(parameters, source_, random);
    shorten_steps(parameters, source_.period_s);
    parameters.set("boom.inlet_compliance", parameters["boom.inlet_compliance"] * compliance_factor);
    for (const auto& [name, value] : fault.parameters)
        parameters.set(name, value);
    return record_scenario_named(source_.scenario)->make(parameters, {Configuration::a, links()}, [&] {
        return random.uniform();
    });
}

ExcavatorSample SimulatedExcavator::sample(const Record& movement, std::size_t index, double begun_s) const {
    PerLink<LinkReader> readers;
    readers.fill({from_});
    ExcavatorSample sample = sample_of(movement, index, links(), readers);
    sample.time_s += begun_s;
    return sample;
}

} // namespace placedpar
