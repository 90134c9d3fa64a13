#include "monitor/protocol/message.hpp"

#include <doctest/doctest.h>

#include <initializer_list>
#include <string>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;
using namespace placedpar::monitor;

namespace {

BadMessage refusal(const std::string& line) {
    try {
        parse_message(line);
    } catch (const BadMessage& bad) {
        return bad;
    }
    FAIL("taken: " << line);
    throw std::logic_error("not reached");
}

template <typename T>
T parsed(const std::string& line) {
    return std::get<T>(parse_message(line));
}

} // namespace

TEST_CASE("a hello is parsed with its defaults") {
    auto plain = parsed<Hello>(R"({"type":"hello","version":1,"machine":"digger-7"})");
    CHECK(plain.machine == "digger-7");
    CHECK(plain.role == Role::control);
    CHECK(plain.parameters == excavator_parameters(Parameters::excavator()));
    CHECK(plain.parameters.links[index_of(Link::boom)].piston_in3_per_rad == doctest::Approx(32 * 22.4));

    auto full = parsed<Hello>(R"({"type":"hello","version":1,"machine":"m","role":"watch","answers":"moved",)"
                              R"("load_every_s":5,"period_s":0.01,"anew":true,)"
                              R"("flow":{"orifice_in3_per_s_in2_sqrt_psi":100,"pump_in3_per_s":175,"tank_psi":25},)"
                              R"("links":{"stick":{"piston_in3_per_rad":400,"spool_lag_per_s":9}}})");
    CHECK(full.role == Role::watch);
    CHECK(full.answers == Answers::moved);
    CHECK(full.anew);
    CHECK(full.load_every_s == 5);
    CHECK(full.parameters.period_s == 0.01);
    CHECK(full.parameters.flow.pump_in3_per_s == 175);
    CHECK(full.parameters.links[index_of(Link::stick)].spool_lag_per_s == 9);
}

TEST_CASE("a configuration is parsed") {
    auto change =
        parsed<ConfigurationChange>(R"({"type":"configuration","configuration":"b","active":["BU","stick"]})");
    CHECK(change.configuration == Configuration::b);
    CHECK(change.active == LinkSet{Link::bucket, Link::stick});
    CHECK(parsed<ConfigurationChange>(R"({"type":"configuration","configuration":"e","active":[]})").active.empty());
}

TEST_CASE("a sample gives the valve's position by spool, voltage or areas") {
    auto sample = parsed<ExcavatorSample>(
        R"({"type":"sample","time_s":1.5,"links":{"BO":{"inlet_psi":1800,"angle_deg":3,"spool_in":0.25},)"
        R"("BU":{"inlet_psi":1900,"angle_deg":-4.5,"servo_V":0.3},)"
        R"("SW":{"inlet_psi":100,"angle_deg":0,"inlet_in2":0.1,"bypass_in2":0.3}}})");
    CHECK(sample.time_s == 1.5);
    CHECK_FALSE(sample.links[index_of(Link::stick)]);
    CHECK(std::get<SpoolPosition>(sample.links[index_of(Link::boom)]->valve).spool_in == 0.25);
    CHECK(std::get<ServoVoltage>(sample.links[index_of(Link::bucket)]->valve).servo_V == 0.3);
    CHECK(std::get<ValveAreas>(sample.links[index_of(Link::swing)]->valve).bypass_in2 == 0.3);
    CHECK(sample.links[index_of(Link::bucket)]->angle_deg == -4.5);
}

TEST_CASE("messages without fields are parsed") {
    auto baseline = parsed<Baseline>(R"({"type":"baseline","links":{"BO":0.0086}})");
    CHECK(baseline.compliance_in3_per_psi[index_of(Link::boom)] == 0.0086);
    CHECK_FALSE(baseline.compliance_in3_per_psi[index_of(Link::bucket)]);
    CHECK_NOTHROW(parsed<StatusRequest>(R"({"type":"status"})"));
    CHECK_NOTHROW(parsed<LoadRequest>(R"({"type":"load"})"));
    CHECK_NOTHROW(parsed<Ping>(R"({"type":"ping"})"));
    CHECK_NOTHROW(parsed<Bye>(R"( { "type" : "bye" } )"));
}

TEST_CASE("a line that is not JSON is refused with the column") {
    CHECK(refusal(R"({"type":"sample" "time_s":1})").column().value_or(0) == 18);
    CHECK(refusal("nonsense").column().value_or(0) == 1);
    CHECK(refusal(R"({"type":"status"} x)").column().value_or(0) == 19);
    CHECK(refusal(R"({"type":"sta)").column().value_or(0) == 13);
    CHECK(refusal("").column().value_or(0) == 1);
    CHECK(refusal("[1,2]").right().find("hello") != std::string::npos);
    CHECK(refusal(std::string(10000, '[')).column().value() <= 10);
}

TEST_CASE("a repeated field is refused") {
    struct Case {
        const char *line, *field;
    };
    for (
        const Case& each : std::initializer_list<Case>{

            {R"({"type":"hello","version":1,"version":1,"machine":"m"})", "version"},
            {R"({"type":"ping","type":"ping"})", "type"},
            {R"({"type":"ping","t\u0079pe":"ping"})", "type"},
            {R"({"type":"sample","time_s":1,"links":{"BO":{"inlet_psi":1,"angle_deg":1,"inlet_psi":2,"spool_in":0.2}}})",
             "links.BO.inlet_psi"},
            {R"({"type":"sample","time_s":1,"links":{"BO":{},"BU":{},"BO":{}}})", "links.BO"},
            {R"({"type":"baseline","links":{"BO":0.0086,"boom":0.0086}})", "links.BO"},
            {R"({"type":"hello","version":1,"machine":"m","links":{"boom":{},"BO":{}}})", "links.BO"}}) {
        CAPTURE(each.line);
        BadMessage bad = refusal(each.line);
        CHECK(bad.field() == each.field);
        CHECK(std::string(bad.what()) == "it is given twice");
    }
    // A name may occur in several objects, but only once in each.
    CHECK_NOTHROW(
        parse_message(R"({"type":"sample","time_s":1,"links":{"BO":{"inlet_psi":1,"angle_deg":1,"spool_in":0.2},)"
                      R"("BU":{"inlet_psi":1,"angle_deg":1,"spool_in":0.2}}})"));
}

TEST_CASE("a wrong field is refused with the expected value") {
    struct Case {
        const char *line, *field, *wrong, *right;
    };
    for (const Case& each : {
             Case{R"({"version":1})", "type", "missing", "string"},
             {R"({"type":"sampel"})", "type", "sampel", "sample"},
             {R"({"type":"hello","version":2,"machine":"m"})", "version", "2", "1"},
             {R"({"type":"hello","version":1,"machine":"a b"})", "machine", "\"a b\" cannot be the name of a machine",
              "letters"},
             {R"({"type":"hello","version":1,"machine":"m","role":"boss"})", "role", "boss", "watch"},
             {R"({"type":"hello","version":1,"machine":"m","perod_s":1})", "perod_s", "no such field", "period_s"},
             {R"({"type":"hello","version":1,"machine":"m","flow":{"pump_in3_per_s":175}})",
              "flow.orifice_in3_per_s_in2_sqrt_psi", "missing", "number"},
             {R"({"type":"configuration","configuration":"f","active":[]})", "configuration", "f", "\"e\""},
             {R"({"type":"configuration","configuration":"a","active":["BX"]})", "active", "BX", "BU, BO"},
             {R"({"type":"configuration","configuration":"a","active":[7]})", "active", "not a string", "BU"},
             {R"({"type":"sample","time_s":"now","links":{}})", "time_s", "now", "number"},
             {R"({"type":"sample","time_s":1e300,"links":{}})", "time_s", "1e+300", "number"},
             {R"({"type":"sample","time_s":1,"links":{"BO":{"angle_deg":1,"spool_in":0.2}}})", "links.BO.inlet_psi",
              "missing", "psi"},
             {R"({"type":"sample","time_s":1,"links":{"BO":{"inlet_psi":20000,"angle_deg":1,"spool_in":0.2}}})",
              "links.BO.inlet_psi", "20000", "10000 psi"},
             {R"({"type":"sample","time_s":1,"links":{"BO":{"inlet_psi":1,"angle_deg":1}}})", "links.BO.spool_in",
              "is missing", "servo_V"},
             {R"({"type":"sample","time_s":1,"links":{"BO":{"inlet_psi":1,"angle_deg":1,"spool_in":1,"servo_V":1}}})",
              "links.BO.spool_in", "twice", "one of"},
             {R"({"type":"sample","time_s":1,"links":{"BO":{"inlet_psi":1,"angle_deg":1,"inlet_in2":1}}})",
              "links.BO.bypass_in2", "missing", "in^2"},
             {R"({"type":"sample","time_s":1,"links":{"BO":{"inlet_psi":1,"angle_deg":1,"spool":1}}})",
              "links.BO.spool_in", "is missing", "spool_in"},
             {R"({"type":"sample","time_s":1,"links":{"BO":{"inlet_psi":1,"angle_deg":1,"spool_in":0.2,"x":1}}})",
              "links.BO.x", "no such field", "inlet_psi"},
             {R"({"type":"baseline","links":{"BO":0.5}})", "links.BO", "0.5", "0.1"},
             {R"({"type":"status","more":1})", "more", "no such field", "type"},
         }) {
        CAPTURE(each.line);
        BadMessage bad = refusal(each.line);
        CHECK(bad.field() == each.field);
        CHECK(std::string(bad.what()).find(each.wrong) != std::string::npos);
        CHECK(bad.right().find(each.right) != std::string::npos);
    }
}
