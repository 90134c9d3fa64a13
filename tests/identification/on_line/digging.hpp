#pragma once

#include "hydraulics/data/frozen_run.hpp"
#include "hydraulics/plant/moving_record.hpp"
#include "hydraulics/plant/requirement.hpp"
#include "identification/on_line/diagnosis.hpp"
#include "identification/on_line/diagnosis_state.hpp"
#include "identification/on_line/record_samples.hpp"
#include "tests/random_job.hpp"

#include <algorithm>
#include <cstdint>
#include <string>

namespace placedpar::identification {

/// A machine that digs for a while. One link has `factor` times the compliance of a sound machine.
struct Digger {
    std::string link = "boom";
    double factor = 1;
    hydraulics::MeasurementNoise noise = hydraulics::low_noise;
    double seconds = 60;
};

/// Returns a record of a random job. Throws UnfitScenario for a job that the machine cannot do. The simulated machine
/// lets some pressures fall below vacuum, which no real machine does: such a job is unfit, too.
inline hydraulics::Record dug(std::uint64_t seed, const Digger& digger = {}) {
    auto parameters = hydraulics::Parameters::excavator();
    const std::string compliance = digger.link + ".inlet_compliance";
    parameters.set(compliance, digger.factor * parameters[compliance]);
    const hydraulics::MovingExcavator machine = moving_excavator(parameters);
    RandomStream random(seed, "sensors");
    hydraulics::Record record = measure_moving(machine, random_job(seed, machine, digger.seconds), digger.noise,
                                               [&] { return random.uniform(); });
    for (hydraulics::Link link : hydraulics::all_links)
        if (std::ranges::min(record.of(link, hydraulics::Sensor::inlet_pressure)) < hydraulics::vacuum_psi)
            throw hydraulics::UnfitScenario("a pressure is below vacuum");
    return record;
}

/// Returns a diagnosis that recognises the configuration.
inline Diagnosis recognising(std::uint64_t seed = 1) {
    Diagnosis diagnosis("digger", excavator_parameters(hydraulics::Parameters::excavator()), {}, seed);
    diagnosis.change(RecognisedConfiguration{});
    return diagnosis;
}

/// Returns the readings of all links.
inline ExcavatorSample sample_at(const hydraulics::Record& record, std::size_t i) {
    hydraulics::PerLink<LinkReader> readers;
    readers.fill({hydraulics::AreasFrom::areas, 0});
    return sample_of(record, i, hydraulics::LinkSet::all(), readers);
}

} // namespace placedpar::identification
