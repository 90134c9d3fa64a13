#include "app/experiment.hpp"
#include "app/identification/record_problem.hpp"
#include "app/single_link/cells.hpp"
#include "hydraulics/compliance_fit.hpp"
#include "hydraulics/record_scenario.hpp"
#include "runtime/random.hpp"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace placedpar {

namespace {

constexpr std::size_t records_a_fault = 20;
constexpr double valve_opens_s = 0.192; // in scenario A

/// What is wrong with the machine: parameters that differ from those of excavator.csv.
struct Fault {
    const char* name;
    std::vector<std::pair<const char*, double>> parameters;
};

const Fault sound{"sound", {}};
const Fault doubled{"compliance doubled", {{"boom.inlet_compliance", 0.0172}}};
const Fault small_leak{"leak of 4 %", {{"fault.leak", 0.001}, {"fault.leak_start", valve_opens_s}}};
const Fault leak{"leak of 7 %", {{"fault.leak", 0.002}, {"fault.leak_start", valve_opens_s}}};
const Fault great_leak{"leak of 14 %", {{"fault.leak", 0.004}, {"fault.leak_start", valve_opens_s}}};
// 0.01 in of spool is 21 mV in the working range, and 20 % of the flow.
const Fault drift{"servo-valve's drift", {{"fault.servo_bias", 0.021}}};

/// Where the records come from, and what they hold.
struct Plant {
    const char *scenario, *noise;
    bool has_servo;
};

Record record_of(const Fault& fault, const Plant& plant, std::uint64_t seed) {
    const RecordScenario& scenario = *record_scenario_named(plant.scenario);
    Parameters parameters = scenario.parameters(Parameters::excavator());
    for (const auto& [name, value] : fault.parameters)
        parameters.set(name, value);
    for (Parameter& row : noise_rows(parameters, plant.noise))
        parameters.put(std::move(row));
    RandomStream sensors(seed, "sensors");
    return scenario.make(parameters, [&] { return sensors.uniform(); });
}

/// The identifier knows nothing of the fault: it takes the machine to be that of excavator.csv.
double identified(const Record& record, AreasFrom from, std::uint64_t seed) {
    IdentificationWay way = service_way();
    way.usable.rising = true;
    RecordProblem prepared =
        prepare(record, Parameters::excavator(), {Configuration::a, {MachineLink::boom}, {}, from}, way);
    return search_transient(prepared.problem, prepared.samples, way, RandomStream(seed, "master"))
        .estimates.back()
        .compliance_in3_per_psi[0];
}

/// Medians over the records.
struct Found {
    double by_spool, by_voltage;
};

Found identified(const Fault& fault, const Plant& plant, std::uint64_t first_seed) {
    std::vector<double> by_spool, by_voltage{0};
    for (std::uint64_t seed = first_seed; seed < first_seed + records_a_fault; ++seed) {
        Record record = record_of(fault, plant, seed);
        by_spool.push_back(identified(record, AreasFrom::spool, seed));
        if (plant.has_servo)
            by_voltage.push_back(identified(record, AreasFrom::servo, seed));
    }
    return {median(by_spool), median(by_voltage)};
}

/// Least squares over the rise: what a leak does to it, beside what is known.
Reading leak_reading() {
    Reading reading{"a leak that the model does not know, scenario A without noise, while the pressure rises: growth "
                    "of C by least squares",
                    {},
                    "",
                    "known",
                    true};
    auto fit = [](const Fault& fault) {
        IdentificationWay way = rising_way();
        RecordProblem prepared =
            prepare(record_of(fault, {"scenario-a", "none", false}, 1), Parameters::excavator(), {}, way);
        std::array start{Parameters::excavator()["boom.inlet_compliance"]};
        return fit_compliances(prepared.problem.circuit(), prepared.samples, prepared.flow, start)
            .value()
            .compliance_in3_per_psi[0];
    };
    double before = fit(sound);
    auto add = [&](const Fault& fault, double known) {
        reading.cells.push_back(
            judged_cell("growth of C", fault.name, "%", known, 100 * (fit(fault) / before - 1), 0.2 * known, 1));
    };
    add(small_leak, 9);
    add(leak, 18);
    add(great_leak, 37);
    return reading;
}

/// What is known of a fault's ratio to the sound machine: nothing of a leak's, which leak_reading() judges.
std::optional<double> known_ratio(const Fault& fault) {
    if (&fault == &doubled)
        return 2.0;
    if (&fault == &sound || &fault == &drift)
        return 1.0;
    return std::nullopt;
}

void add_fault(Reading& reading, const Fault& fault, const Plant& plant, const Found& before, std::uint64_t seed) {
    Found found = identified(fault, plant, seed);
    reading.cells.push_back(plain_cell("C by the spool", fault.name, "in^3/psi", found.by_spool, 5));
    double ratio = found.by_spool / before.by_spool;
    auto known = known_ratio(fault);
    reading.cells.push_back(known ? judged_cell("  of the sound machine's", fault.name, "", *known, ratio, 0.15, 2)
                                  : plain_cell("  of the sound machine's", fault.name, "", ratio, 2));
    if (!plant.has_servo)
        return;
    reading.cells.push_back(plain_cell("C by the voltage", fault.name, "in^3/psi", found.by_voltage, 5));
    reading.cells.push_back(
        plain_cell("  of the sound one's", fault.name, "", found.by_voltage / before.by_voltage, 2));
}

Reading fault_reading(std::string name, const Plant& plant, std::uint64_t seed) {
    Reading reading{std::move(name), {}, "", "known", true};
    Found before = identified(sound, plant, seed);
    for (const Fault* fault : {&sound, &doubled, &leak, &great_leak, &drift})
        if (fault != &drift || plant.has_servo)
            add_fault(reading, *fault, plant, before, seed);
    return reading;
}

} // namespace

Replay replay_faults(const ReplayContext& context) {
    Replay replay;
    context.progress("faults of the simple plant");
    replay.readings.push_back(
        fault_reading(fmt::format("simple plant, low noise, median of {} records", records_a_fault),
                      {"scenario-a", "low", false}, context.seed));
    replay.readings.push_back(leak_reading());
    context.progress("faults of the measured machine");
    replay.readings.push_back(
        fault_reading(fmt::format("measured machine, mid noise, median of {} records", records_a_fault),
                      {"excavator", "mid", true}, context.seed));
    replay.readings.back().notes =
        "a drift of the servo-valve shows by the voltage only, a fault of hose or cylinder by both\n";
    replay.fingerprint = fingerprint_of(replay.readings);
    return replay;
}

} // namespace placedpar
