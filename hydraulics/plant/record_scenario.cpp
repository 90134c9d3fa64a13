#include "hydraulics/plant/record_scenario.hpp"

#include "hydraulics/plant/boom_sensors.hpp"
#include "hydraulics/plant/excavator_record.hpp"
#include "hydraulics/plant/excavator_values.hpp"
#include "hydraulics/plant/moving_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <utility>

namespace placedpar::hydraulics {

namespace {

bool in_group(std::string_view name, std::initializer_list<std::string_view> groups) {
    return std::ranges::any_of(groups, [&](std::string_view group) { return name.starts_with(group); });
}

/// Returns whether every scenario uses the parameter. No scenario uses the rounded constants, which are for other
/// experiments.
bool used_by_all(std::string_view name) {
    return in_group(name, {"flow.", "boom.", "noise.", "sensors.period"}) && !name.starts_with("flow.rounded.");
}

bool used_by_simple_plant(std::string_view name) {
    return used_by_all(name) || in_group(name, {"fault.leak", "fault.spool_offset"});
}

bool scenario_a_uses(std::string_view name) { return used_by_simple_plant(name) || name.starts_with("scenario_a."); }

/// The parameters in which scenario B's machine differs from scenario A's.
constexpr std::array<std::string_view, 5> machine_of_b{"mass", "damping", "friction", "gravity", "spool_lag"};

bool scenario_b_uses(std::string_view name) {
    constexpr std::string_view prefix = "scenario_b.";
    if (name.starts_with(prefix))
        return std::ranges::find(machine_of_b, name.substr(prefix.size())) == machine_of_b.end();
    return used_by_simple_plant(name);
}

bool excavator_uses(std::string_view name) {
    if (name == "boom.friction_velocity") // the measured excavator has stiction instead
        return false;
    return used_by_all(name) ||
           in_group(name, {"fault.", "excavator.", "valve.", "pump.", "hose.", "stiction.", "oil.", "sensors."});
}

Parameters as_they_are(const Parameters& machine) { return machine; }

Parameters with_machine_of_b(const Parameters& machine) {
    Parameters parameters = machine;
    for (std::string_view each : machine_of_b) {
        Parameter row = *machine.find(fmt::format("scenario_b.{}", each));
        row.name = fmt::format("boom.{}", each);
        row.source = "scenario B";
        parameters.put(std::move(row));
    }
    return parameters;
}

Record simulate_and_measure(const ExcavatorScenario& scenario, const Parameters& parameters,
                            const UniformSource& uniform) {
    return measure_excavator(simulate_excavator(scenario), scenario, parameters["sensors.period"],
                             measurement_noise(parameters), uniform);
}

Record record_simple_plant(const Parameters& parameters, std::string_view motion, const UniformSource& uniform) {
    Record record = simulate_and_measure(single_boom_scenario(parameters, motion), parameters, uniform);
    for (double& spool_in : record.of(Link::boom, Sensor::spool))
        spool_in += parameters["fault.spool_offset"];
    return record;
}

Record record_scenario_a(const Parameters& parameters, const LinksInMotion&, const UniformSource& uniform) {
    return record_simple_plant(parameters, "scenario_a", uniform);
}

Record record_scenario_b(const Parameters& parameters, const LinksInMotion&, const UniformSource& uniform) {
    return record_simple_plant(parameters, "scenario_b", uniform);
}

Record record_excavator(const Parameters& parameters, const LinksInMotion&, const UniformSource& uniform) {
    MeasuredExcavator excavator = measured_excavator(parameters);
    return read_boom_sensors(simulate_measured_excavator(excavator), excavator, boom_sensors(parameters), uniform);
}

bool two_links_use(std::string_view name) {
    if (in_group(name, {"flow.", "bucket.", "noise.", "sensors.period", "fault.leak"}))
        return name != "noise.spool" && !name.starts_with("flow.rounded.");
    constexpr std::array<std::string_view, 6> boom{"inlet_area", "moment_arm", "mass",
                                                   "gravity",    "spool_lag",  "inlet_compliance"};
    if (name.starts_with("boom."))
        return std::ranges::find(boom, name.substr(5)) != boom.end();
    return name.starts_with("two_links.") && !in_group(name, {"two_links.stick", "two_links.swing"});
}

Record record_two_links(const Parameters& parameters, const LinksInMotion&, const UniformSource& uniform) {
    return simulate_and_measure(two_link_scenario(parameters), parameters, uniform);
}

bool links_use(std::string_view name) {
    if (in_group(name, {"boom.", "stick.", "swing."})) // a link uses a row if the bucket has a row of this name
        return Parameters::excavator().find(fmt::format("bucket{}", name.substr(name.find('.')))) != nullptr;
    if (name.starts_with("two_links."))
        return name.ends_with("_damping") ||
               !in_group(name, {"two_links.boom", "two_links.bucket_inlet_final", "two_links.bucket_bypass_final"});
    return two_links_use(name) || name.starts_with("controller.");
}

Record record_links(const Parameters& parameters, const LinksInMotion& moving, const UniformSource& uniform) {
    return simulate_and_measure(step_scenario(moving.configuration, moving.links, parameters), parameters, uniform);
}

bool digging_uses(std::string_view name) {
    if (name == "oil.bulk_modulus" || name == "valve.dead_time" || name == "valve.drain_laminar")
        return true;
    if (name == "controller.asked_flow" || name.starts_with("fault.") || name == "two_links.duration" ||
        name == "two_links.integration_step")
        return false;
    return links_use(name) || in_group(name, {"cross_over.", "pipe.", "arm.", "joystick.", "tracking.", "digging."});
}

Record record_digging(const Parameters& parameters, const LinksInMotion& moving, const UniformSource& uniform) {
    return measure_moving(moving_excavator(parameters), *moving.job, measurement_noise(parameters), uniform);
}

constexpr std::array<RecordScenario, 5> scenarios{{
    {"scenario-a", "the simple plant: the speed of the boom steps to 4 deg/s", as_they_are, scenario_a_uses,
     record_scenario_a},
    {"scenario-b", "the simple plant, made heavy and slow: the speed of the boom ramps up to 4 deg/s",
     with_machine_of_b, scenario_b_uses, record_scenario_b},
    {"two-links", "bucket and boom on branch 1 of configuration a: the speeds of both step up (thesis 3.2)",
     as_they_are, two_links_use, record_two_links},
    {"links", "any links in any configuration of the main valve: the speeds of all step up", as_they_are, links_use,
     record_links, true},
    {"excavator", "the measured machine: hoses with inertia, pump ripple, stiction, dead time, converters", as_they_are,
     excavator_uses, record_excavator},
}};

} // namespace

std::span<const RecordScenario> record_scenarios() { return scenarios; }

const RecordScenario& digging_scenario() {
    static constexpr RecordScenario digging{
        "excavator", "all links of the simplified machine, moved by a job, with the cross-over network", as_they_are,
        digging_uses, record_digging};
    return digging;
}

const RecordScenario* record_scenario_named(std::string_view name) {
    const auto* found = std::ranges::find(scenarios, name, &RecordScenario::name);
    return found == scenarios.end() ? nullptr : found;
}

std::vector<Parameter> noise_rows(const Parameters& machine, std::string_view level) {
    struct Level {
        std::string_view name;
        MeasurementNoise noise;
    };
    constexpr std::array<Level, 4> levels{
        {{"none", no_noise}, {"low", low_noise}, {"mid", mid_noise}, {"high", high_noise}}};
    const auto* found = std::ranges::find(levels, level, &Level::name);
    std::vector<Parameter> rows;
    if (found == levels.end())
        return rows;
    for (auto [name, value] :
         {std::pair{"noise.pressure", found->noise.pressure_psi}, std::pair{"noise.angle", found->noise.angle_deg},
          std::pair{"noise.spool", found->noise.spool_in}, std::pair{"noise.area", found->noise.area_share}}) {
        Parameter row = *machine.find(name);
        row.value = value;
        rows.push_back(std::move(row));
    }
    return rows;
}

} // namespace placedpar::hydraulics
