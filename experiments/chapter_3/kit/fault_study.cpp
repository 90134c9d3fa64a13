#include "experiments/chapter_3/kit/fault_study.hpp"

#include "identification/compliance_fit.hpp"
#include "identification/compliance_search.hpp"
#include "identification/transient_search.hpp"
#include "runtime/random.hpp"

#include <array>

namespace placedpar {

using namespace hydraulics;
using namespace identification;

namespace {

constexpr double valve_opens_s = 0.192; // in scenario A

ComplianceSearch rising(const Record& record, const Question& question, IdentificationWay& way) {
    way.usable.rising = true;
    return prepare(record, Parameters::excavator(), question, way);
}

} // namespace

PlantFault no_fault() { return {"sound", {}}; }

PlantFault doubled_compliance() { return {"compliance doubled", {{"boom.inlet_compliance", 0.0172}}}; }

PlantFault leak_of(const char* name, double leak_in3_per_s_psi) {
    return {name, {{"fault.leak", leak_in3_per_s_psi}, {"fault.leak_start", valve_opens_s}}};
}

PlantFault drift_of(double bias_v) { return {"servo-valve's drift", {{"fault.servo_bias", bias_v}}}; }

Record record_of(const PlantFault& fault, const RecordSource& source, std::uint64_t seed) {
    const RecordScenario& scenario = *record_scenario_named(source.scenario);
    Parameters parameters = scenario.parameters(Parameters::excavator());
    for (const auto& [name, value] : fault.parameters)
        parameters.set(name, value);
    for (Parameter& row : noise_rows(parameters, source.noise))
        parameters.put(std::move(row));
    RandomStream sensors(seed, "sensors");
    return scenario.make(parameters, {}, [&] { return sensors.uniform(); });
}

SearchRun search_faulty(const Record& record, AreasFrom from, std::uint64_t seed) {
    IdentificationWay way = rising_way(); // Gray code and an elite, as an engineer would choose
    way.coding = Coding::gray;
    way.search.elite = 1;
    way.usable.skipped = 2;
    ComplianceSearch prepared = rising(record, {Configuration::a, {Link::boom}, {}, from}, way);
    return search_transient(prepared.problem, prepared.samples, way, RandomStream(seed, "master"));
}

double identified(const Record& record, AreasFrom from, std::uint64_t seed) {
    return search_faulty(record, from, seed).estimates.back().compliance_in3_per_psi[0];
}

double least_squares(const Record& record) {
    IdentificationWay way = thesis_way();
    ComplianceSearch prepared = rising(record, {}, way);
    std::array start{Parameters::excavator()["boom.inlet_compliance"]};
    return fit_compliances(prepared.problem.circuit(), prepared.samples, prepared.flow, start)
        .value()
        .compliance_in3_per_psi[0];
}

} // namespace placedpar
