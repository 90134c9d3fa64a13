#pragma once

#include "hydraulics/data/frozen_run.hpp"
#include "hydraulics/plant/moving_record.hpp"
#include "hydraulics/plant/requirement.hpp"
#include "identification/on_line/diagnosis.hpp"
#include "identification/on_line/diagnosis_state.hpp"
#include "identification/on_line/record_samples.hpp"
#include "tests/random_job.hpp"

#include <algorithm>

namespace placedpar::identification {

/// Returns a record of a machine that digs. Throws UnfitScenario for a job that the machine cannot do. The simulated
/// machine lets some pressures fall below vacuum, which no real machine does: such a job is unfit, too.
inline hydraulics::Record dug(std::uint64_t seed, double seconds, double boom_factor = 1) {
    auto parameters = hydraulics::Parameters::excavator();
    parameters.set("boom.inlet_compliance", boom_factor * parameters["boom.inlet_compliance"]);
    const hydraulics::MovingExcavator machine = moving_excavator(parameters);
    RandomStream random(seed, "sensors");
    hydraulics::Record record = measure_moving(machine, random_job(seed, machine, seconds), hydraulics::low_noise,
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
