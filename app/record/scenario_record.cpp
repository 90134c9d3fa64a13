#include "app/record/scenario_record.hpp"

#include "hydraulics/data/units.hpp"
#include "hydraulics/plant/dig_job.hpp"
#include "hydraulics/plant/requirement.hpp"
#include "runtime/random.hpp"
#include "text/program_name.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace placedpar {

using namespace hydraulics;

namespace {

/// Throws UserError if a reading is greater than any sensor reads. Extreme parameters can cause such readings.
void require_measurable(const Record& record, const RecordScenario& scenario) {
    auto reading = first_unmeasurable(record);
    if (!reading)
        return;
    std::string value = std::isnan(reading->value) ? "nan" : fmt::format("{:.3g}", reading->value);
    throw UserError(fmt::format(
        "{} cannot be simulated with these parameters: {}.{} would be {} {} at {:.3f} s; some parameter is far "
        "too large or far too small",
        scenario.name, name_of(reading->link), name_of(reading->sensor), value,
        units_of(quantity_of(reading->sensor)).front().name, reading->time_s));
}

/// Simulates the record. Throws UserError if extreme parameters make the pressures diverge before the first reading.
Record simulated(const RecordScenario& scenario, const LinksInMotion& moving, const Parameters& parameters,
                 RandomStream noise) {
    try {
        return scenario.make(parameters, moving, [&] { return noise.uniform(); });
    } catch (const UnfitScenario& unfit) { // a job can be impossible, for example if the soil's force cancels a load
        throw UserError(moving.job ? fmt::format("--job {}: {}", moving.job->name, unfit.what()) : unfit.what());
    } catch (const std::domain_error&) { // from Boost's solver: the flows at the ends of the interval have equal signs
        throw UserError(fmt::format("{} cannot be simulated with these parameters: no pressure balances the "
                                    "flows; some parameter is far too large or far too small",
                                    scenario.name));
    }
}

/// Returns the options of `placedpar record` that select the motion.
std::string options_of(const LinksInMotion& moving, const RecordScenario& scenario) {
    if (moving.job)
        return fmt::format(" --job {}", moving.job->name);
    if (!scenario.any_links)
        return "";
    std::vector<std::string_view> names;
    for (Link link : all_links)
        if (moving.links.contains(link))
            names.push_back(name_of(link));
    return fmt::format(" --link {} --configuration {}", fmt::join(names, ","), name_of(moving.configuration));
}

/// The parameters that differ from the program's defaults: as options, and as lines with both values.
struct ChangedParameters {
    std::string options, lines;
};

ChangedParameters changes_of(const RecordScenario& scenario, const Parameters& parameters) {
    const Parameters own = scenario.parameters(Parameters::excavator());
    ChangedParameters changed;
    for (const Parameter& parameter : parameters.all()) {
        const Parameter& before = *own.find(parameter.name);
        if (!scenario.uses(parameter.name) || parameter.value == before.value)
            continue;
        changed.options += fmt::format(" --set {}={}", parameter.name, parameter.value);
        changed.lines +=
            fmt::format("{} = {} {}, not {}\n", parameter.name, parameter.value, parameter.unit, before.value);
    }
    return changed;
}

/// Returns whether the parameter is the compliance of a moving link.
bool is_compliance_of(const LinksInMotion& moving, const Parameter& parameter, const RecordScenario& scenario) {
    if (!scenario.uses(parameter.name) || !parameter.name.ends_with("let_compliance"))
        return false;
    auto link = [&] { return *link_named(parameter.name.substr(0, parameter.name.find('.'))); };
    return !scenario.any_links || moving.links.contains(link());
}

std::string true_compliances(const RecordScenario& scenario, const LinksInMotion& moving,
                             const Parameters& parameters) {
    std::vector<std::string> all;
    for (const Parameter& parameter : parameters.all())
        if (is_compliance_of(moving, parameter, scenario))
            all.push_back(fmt::format("true {} {} {}", parameter.name, parameter.value, parameter.unit));
    return fmt::format("{}", fmt::join(all, ", "));
}

std::string description_of(const RecordScenario& scenario, const LinksInMotion& moving, const Parameters& parameters,
                           std::uint64_t seed) {
    auto [options, lines] = changes_of(scenario, parameters);
    std::string command = fmt::format("{} record {}{} --seed {}{}", program_name(), scenario.name,
                                      options_of(moving, scenario), seed, options);
    return fmt::format("{}: {}\nmade by: {}\nseed {}; {}\n{}{}\n", scenario.name, scenario.about, command, seed,
                       lines.empty() ? "every parameter has the program's default value"
                                     : "parameters that differ from the program's defaults:",
                       lines, true_compliances(scenario, moving, parameters));
}

} // namespace

Record scenario_record(const RecordScenario& scenario, const LinksInMotion& moving, const Parameters& parameters,
                       std::uint64_t seed) {
    Record record = simulated(scenario, moving, parameters, RandomStream(seed, "sensors"));
    require_measurable(record, scenario);
    record.description = description_of(scenario, moving, parameters, seed);
    return record;
}

} // namespace placedpar
