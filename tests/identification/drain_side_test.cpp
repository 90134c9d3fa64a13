#include "boom_records.hpp"
#include "hydraulics/plant/record_scenario.hpp"
#include "identification/whole_search.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;

namespace {

/// Returns a record of the measured machine at low noise.
Record measured(std::uint64_t seed, double outlet_in3_per_psi) {
    Parameters machine = Parameters::excavator();
    for (Parameter& row : noise_rows(machine, "low"))
        machine.put(std::move(row));
    Parameter row = *machine.find("boom.outlet_compliance");
    row.value = outlet_in3_per_psi;
    machine.put(std::move(row));
    RandomStream sensors(seed, "sensors");
    return record_scenario_named("excavator")->make(machine, {}, [&] { return sensors.uniform(); });
}

Question drain_question() {
    Question question;
    question.side = Side::outlet;
    return question;
}

Identified identify_drain_of(const Record& record, std::uint64_t seed) {
    const WholeWay whole = whole_way(1, Side::outlet);
    return identify_whole(prepare(record, Parameters::excavator(), drain_question(), whole.way), whole, seed);
}

} // namespace

TEST_CASE("the compliance of the drain side is found within 10 % on the measured machine") {
    for (double truth : {0.006, 0.012}) // neither is within 10 % of the inlet side's 0.0086
        for (std::uint64_t seed = 3001; seed <= 3010; ++seed) {
            const Identified found = identify_drain_of(measured(seed, truth), seed);
            CAPTURE(seed);
            CHECK(error_percent(found.links.front().compliance_in3_per_psi, truth) <= 10);
            CHECK(compliance_name(found.circuit.front()) == "C_BOo");
            CHECK_FALSE(found.links.front().flagged(FlagKind::falls));
            CHECK_FALSE(found.links.front().flagged(FlagKind::still_valve));
        }
}

TEST_CASE("a record at rest, or whose outlet pressure is at the tank's, has no usable sample of the drain side") {
    Record shut = measured(1, 0.006), drained = shut;
    for (double& spool : shut.of(Link::boom, Sensor::spool))
        spool = 0.15;
    for (double& psi : drained.of(Link::boom, Sensor::outlet_pressure))
        psi = 16.2;
    for (const Record& record : {shut, drained})
        CHECK(prepare(record, Parameters::excavator(), drain_question(), thesis_way()).samples.empty());
}

TEST_CASE("the error of the drain side is that of equation 3.4") {
    const FlowConstants flow = fitted_flow_constants();
    const CircuitProblem problem(drain_circuit(Link::boom), flow, 10, InletFlow::as_signed);
    const double piston = 17 * 1.2, slope = 500, psi = 120, outlet_in2 = 0.02, compliance = 0.004;
    const std::vector<double> sample{psi, slope, -piston, std::numeric_limits<double>::infinity(), outlet_in2};
    const double drained =
        flow.orifice_in3_per_s_in2_sqrt_psi * outlet_in2 * std::sqrt(psi - flow.tank_psi); // k a_o sqrt(P_o - P_e)
    CHECK(problem.error_of<double>(std::span(&compliance, 1), std::span<const double>(sample)) ==
          doctest::Approx(std::abs(piston - compliance * slope - drained)));
}

TEST_CASE("the drain sides of other links, and measured areas, are refused") {
    const Record record = measured(1, 0.006);
    auto refusal = [&](Question question) -> std::string {
        try {
            prepare(record, Parameters::excavator(), question, thesis_way());
        } catch (const UserError& refused) {
            return refused.what();
        }
        return "";
    };
    Question stick = drain_question(), areas = drain_question();
    stick.links = {Link::stick};
    areas.areas_from = AreasFrom::areas;
    CHECK(refusal(stick) ==
          "--side outlet does not work for stick: the machine's constants describe only the outlet side of the boom "
          "(boom.outlet_area, A.7 to A.9)");
    CHECK(refusal(areas) == "--side outlet: no sensor reads the area of an outlet; compute it from the spool or the "
                            "servo-valve, with --areas-from spool or --areas-from servo");
    Record without = record;
    without.of(Link::boom, Sensor::outlet_pressure).clear();
    CHECK_THROWS_WITH_AS(prepare(without, Parameters::excavator(), drain_question(), thesis_way()),
                         "the record has no channel boom.outlet_pressure; it has boom.inlet_pressure, boom.angle, "
                         "boom.spool, boom.servo",
                         UnfitRecord);
}
