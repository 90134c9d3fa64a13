// Tests that everything printed about a run is also in its JSON document.

#include "netlist/run_report.hpp"
#include "report/run_report.hpp"
#include "text/user_error.hpp"

#include <boost/json.hpp>
#include <doctest/doctest.h>

#include <chrono>
#include <string>

using namespace placedpar;
using namespace std::chrono_literals;

namespace {

RunReport of_one_second() {
    RunReport report;
    report.result.ending = Ending::completed;
    report.result.time = 1s;
    return report;
}

std::string printed(const RunReport& report) { return print_report(report, Network()); }

boost::json::object document(const RunReport& report) { return report_json(report, Network(), Manifest()); }

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Returns the only row of this table in a document.
boost::json::object only(const boost::json::object& json, const char* table) {
    REQUIRE(json.at(table).as_array().size() == 1);
    return json.at(table).as_array().front().as_object();
}

} // namespace

TEST_CASE("measurements are printed as numbers with units, or as texts") {
    RunReport report = of_one_second();
    report.measurements = {{"master", "T_exe", 12.5, "ms"}, {"slave", "state", std::string("idle"), ""}};
    CHECK(has(printed(report), "\nprocess  measured             value  unit\n"
                               "master   T_exe                 12.5  ms\n"
                               "slave    state                 idle\n"));
    boost::json::array rows = document(report).at("measurements").as_array();
    CHECK(rows[0].at("value") == 12.5);
    CHECK(rows[0].at("unit") == "ms");
    CHECK(rows[1].at("value") == "idle");
}

TEST_CASE("the load of processors is printed in percent, and in picoseconds in JSON") {
    RunReport report = of_one_second();
    report.processors.push_back({"t[0]", "T800", 250ms, 0ms, 0, 0ms});
    CHECK(has(printed(report), "\nprocessor  type      busy\nt[0]       T800     25.0%\n"));
    boost::json::object row = only(document(report), "processors");
    CHECK(row.at("busy") == 0.25);
    CHECK(row.at("busy_ps") == 250'000'000'000);
    CHECK(row.at("packets_passed_on") == 0);
}

TEST_CASE("processors that pass packets on have two more columns") {
    RunReport report = of_one_second();
    report.processors.push_back({"t[0]", "T800", 250ms, 0ms, 0, 0ms});
    report.processors.back().packets_passed_on = 3;
    report.processors.back().passing_on = 10ms;
    CHECK(has(printed(report), "\nprocessor  type      busy  passing on   packets\n"
                               "t[0]       T800     25.0%        1.0%         3\n"));
    CHECK(only(document(report), "processors").at("passing_on_ps") == 10'000'000'000);
}

TEST_CASE("only links that carried bytes are printed") {
    RunReport report = of_one_second();
    report.links = {{"t[0].link[0]", "t[1].link[0]", 100, 500ms}, {"a rather long name", "another long name", 0, 0ms}};
    CHECK(has(printed(report), "\nlink                                          bytes   occupied\n"
                               "t[0].link[0] -> t[1].link[0]                    100      50.0%\n"));
    CHECK_FALSE(has(printed(report), "another long name"));
    CHECK(document(report).at("links").as_array().size() == 2);
    report.links.front().bytes = 0;
    CHECK_FALSE(has(printed(report), "occupied"));
}

TEST_CASE("a bus is reported with its masters and broadcasts") {
    RunReport report = of_one_second();
    report.buses.push_back({"vme", 100ms, {{"b1", 3, 7, 28, 2, 0, 20ms, 2us}}, {}});
    CHECK(has(printed(report), "\nbus vme, busy 10.0%\n"
                               "master  level      words      bytes     grants  waiting  longest wait  errors\n"
                               "b1          3          7         28          2     2.0%      2.000 us       0\n"));
    CHECK_FALSE(only(document(report), "buses").contains("broadcasts"));
    report.buses.front().broadcasts.push_back({"host.to_masters", 4, 2, 80});
    CHECK(has(printed(report), "broadcast        adapters   messages      bytes\n"
                               "host.to_masters         4          2         80\n"));
    boost::json::object bus = only(document(report), "buses");
    CHECK(only(bus, "masters").at("longest_wait_ps") == 2'000'000);
    CHECK(only(bus, "broadcasts").at("adapters") == 4);
}

TEST_CASE("a device of a new kind names its report columns") {
    RunReport report = of_one_second();
    report.devices.push_back(
        {"ring r", 10ms, {"station", "frames", "waited"}, {{"t[0]", {std::uint64_t{5}, Time{50ms}}}}});
    CHECK(has(printed(report), "\nring r, busy 1.0%\n"
                               "station     frames     waited\n"
                               "t[0]             5       5.0%\n"));
    boost::json::object row = only(only(document(report), "devices"), "rows");
    CHECK(row.at("station") == "t[0]");
    CHECK(row.at("frames") == 5);
    CHECK(row.at("waited_ps") == 50'000'000'000);
}

TEST_CASE("the report shows how long processes waited, and the beginning of unfinished waits") {
    RunReport report = of_one_second();
    report.processes = {{"master", "t[0]", 400ms, {}}, {"slave", "t[1]", 100ms, Time{900ms}}};
    CHECK(has(printed(report), "\nprocess  on    waiting\n"
                               "master   t[0]    40.0%\n"
                               "slave    t[1]    10.0%, the last wait since 900.000 ms\n"));
    boost::json::array rows = document(report).at("processes").as_array();
    CHECK_FALSE(rows[0].as_object().contains("waits_since_ps"));
    CHECK(rows[1].at("waits_since_ps") == 900'000'000'000);
}

TEST_CASE("after a deadlock no shares of the time are reported") {
    RunReport report = of_one_second();
    report.result.ending = Ending::stuck;
    report.processors.push_back({"t[0]", "T800", 250ms, 0ms, 0, 0ms});
    report.processes = {{"master", "t[0]", 400ms, Time{600ms}}};
    CHECK(has(printed(report), "t[0]       T800    250.000 ms\n"));
    CHECK(has(printed(report), "master   t[0]  for ever, from 600.000 ms on\n"));
    CHECK(only(document(report), "processors").at("busy").is_null());
}

TEST_CASE("a device that reports a wrong number of figures is refused by name") {
    RunReport report = of_one_second();
    report.devices.push_back({"ring r", 10ms, {"station", "frames", "waited"}, {{"w[0]", {std::uint64_t{1}}}}});
    CHECK_THROWS_WITH_AS(printed(report),
                         "ring r reports 1 figures of \"w[0]\", expected 2: one for each column but the first",
                         UserError);
}
