#include "hydraulics/data/parameter_range.hpp"
#include "hydraulics/data/parameters.hpp"
#include "hydraulics/plant/link_mechanics.hpp"
#include "tests/nearly.hpp"
#include "text/diagnostic.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <set>
#include <stdexcept>

using namespace placedpar;
using namespace placedpar::hydraulics;

namespace {

constexpr std::string_view header = "name,value,unit,mark,source\n";

std::vector<Diagnostic> faults_of(const std::string& rows, Parameters* machine = nullptr) {
    Parameters read = Parameters::excavator();
    std::vector<Diagnostic> faults;
    read.read(std::string(header) + rows, faults);
    if (machine)
        *machine = read;
    return faults;
}

} // namespace

TEST_CASE("every constant has a mark, and constants that are not ours have a source") {
    for (const Parameter& parameter : Parameters::excavator().all()) {
        CAPTURE(parameter.name);
        CHECK(std::set<std::string>{"thesis", "fitted", "ours"}.contains(parameter.mark));
        CHECK((parameter.mark == "ours" || !parameter.source.empty()));
    }
}

TEST_CASE("the thesis's figures and the fitted constants have the printed values") {
    const Parameters& machine = Parameters::excavator();
    CHECK(machine["boom.inlet_compliance"] == 0.0086);
    CHECK(machine.find("boom.inlet_compliance")->mark == "thesis");
    CHECK(machine["flow.orifice"] == 99.83);
    CHECK(machine["flow.pump"] == 175.08);
    CHECK(machine["flow.tank"] == 16.2);
    CHECK_THROWS_WITH_AS(machine["boom.colour"], "the machine has no parameter boom.colour", UnknownParameter);
}

TEST_CASE("a user's file replaces the constants that it names, in any unit") {
    Parameters machine;
    CHECK(faults_of("# ours\nboom.inlet_area,206.45,cm^2,measured,\"data sheet, page 3\"\n"
                    "boom.inlet_compliance,2.044e-11,m^3/Pa,thesis,\n",
                    &machine)
              .empty());
    CHECK(machine["boom.inlet_area"] == doctest::Approx(32).epsilon(1e-4));
    CHECK(machine["boom.inlet_compliance"] == test::nearly(0.0086, 1e-4));
    CHECK(machine.find("boom.inlet_area")->source == "data sheet, page 3");
    CHECK(machine["boom.outlet_area"] == 17);
    CHECK(single_boom_mechanics(machine).inlet_area_in2 == machine["boom.inlet_area"]);
}

TEST_CASE("every constant of the excavator is in its range, and ranges exclude impossible values") {
    for (const Parameter& parameter : Parameters::excavator().all()) {
        CAPTURE(parameter.name);
        ParameterRange range = range_of(parameter.name);
        CHECK(range.contains(parameter.value));
        CHECK(!range.contains(NAN));
        CHECK(!range.contains(INFINITY));
    }
    for (const char* positive : {"flow.orifice", "flow.pump", "boom.inlet_area", "boom.moment_arm", "bucket.mass",
                                 "boom.inlet_compliance", "two_links.boom_spool_lag", "sensors.period"}) {
        CAPTURE(positive);
        CHECK(range_of(positive).expected() == "above 0");
        CHECK(!range_of(positive).contains(0));
        CHECK(range_of(positive).contains(1e-12));
    }
    for (const char* not_negative :
         {"noise.pressure", "noise.area", "fault.leak", "boom.friction", "sensors.spool_bits"}) {
        CAPTURE(not_negative);
        CHECK(range_of(not_negative).expected() == "0 or above");
        CHECK(range_of(not_negative).contains(0));
        CHECK(!range_of(not_negative).contains(-1e-12));
    }
    for (const char* any : {"fault.spool_offset", "fault.servo_drift", "boom.gravity", "flow.tank"})
        CHECK(range_of(any).contains(-1));
}

TEST_CASE("errors in a user's file are reported with their place") {
    auto check = [](const std::string& row, std::size_t column, const char* message) {
        auto faults = faults_of(row);
        REQUIRE(faults.size() == 1);
        CHECK(faults[0].severity == Severity::error);
        CHECK(faults[0].location.line == 2);
        CHECK(faults[0].location.column == column);
        CHECK(faults[0].message == message);
    };
    check("boom.colour,1,in,ours,\n", 1, "the machine has no parameter \"boom.colour\"");
    check("boom.inlet_area,32,psi,ours,\n", 20, "\"psi\" is not a unit of area");
    check("boom.inlet_area,x,in^2,ours,\n", 17, "\"x\" is not a finite number");
    check("boom.inlet_area,1e999,in^2,ours,\n", 17, "\"1e999\" is beyond the range of numbers");
    check("boom.inlet_area,32,in^2,guessed,\n", 25, "\"guessed\" is not a mark");
    check("boom.inlet_area,0,in^2,ours,\n", 17, "boom.inlet_area cannot be 0");
    check("noise.pressure,-5,psi,ours,\n", 16, "noise.pressure cannot be -5");
    check("boom.inlet_area,32,in^2,ours\n", 25, "the row has the wrong number of values: 4, expected 5");

    std::vector<Diagnostic> faults;
    Parameters machine = Parameters::excavator();
    machine.read("time [s],boom.angle [deg]\n0,1\n", faults);
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].message == "this is not the header of a table of parameters");
    faults.clear();
    machine.read("", faults);
    CHECK(has_errors(faults));
}
