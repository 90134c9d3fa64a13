// Tests the report about waiting processes when a run can go no further.

#include "explore/problems.hpp"
#include "netlist/machine.hpp"
#include "netlist/read.hpp"
#include "report/run_report.hpp"

#include <boost/json.hpp>
#include <doctest/doctest.h>

#include <chrono>
#include <map>
#include <sstream>
#include <string>

using namespace placedpar;

namespace {

/// A master and its slave, still rehearsing when the work is over, and a consumer that waits for a sixth packet
/// although only five are sent.
constexpr const char* farm_beside_a_deadlock = R"(
workstation sun;
T800 t[2], x;
connect sun.link[0] to t[0].link[0];
connect t[0].link[1] to t[1].link[0];
connect t[1].link[1] to x.link[0];
process (interface (output to_masters[1])) host;
process (interface (input from_host, output to_slaves, input from_slaves)) master;
process (interface (input from_master, output to_master)) slave;
process (interface (output out)) producer;
process (interface (input in)) consumer;
use "ga.host" for host;
use "ga.master" for master;
use "ga.slave" for slave;
use "csp.producer" for producer;
use "csp.consumer" for consumer;
master (population = 10, slaves = 1, rehearsals = 3);
producer (count = 5);
consumer (count = 6);
connect host.to_masters[0] to master.from_host;
connect master.to_slaves to slave.from_master;
connect slave.to_master to master.from_slaves;
connect producer.out to consumer.in;
place host on sun;
place master on t[0];
place slave on t[1];
place producer on x;
place consumer on x;
)";

/// Two buffers that wait for each other, and a consumer that waits for a second packet although only one is sent. The
/// report counts lines from the first.
constexpr const char* buffers_and_a_consumer = R"(workstation sun;
T800 t;
connect sun.link[0] to t.link[0];
process (interface (input in, output out)) a,
                                           b;
process (interface (input in)) c;
process (interface (output out)) d;
use "csp.identity" for a;
use "csp.identity" for b;
use "csp.consumer" for c;
use "csp.producer" for d;
c (count = 2);
d (count = 1);
connect a.out to b.in;
connect b.out to a.in; connect d.out
    to c.in;
place a on t;
place b on t;
place c on t;
place d on t;
)";

using NetlistLines = std::map<std::string, std::string>;

/// Returns the "netlist" entry of each row of a table of the deadlock in the JSON report.
NetlistLines lines_in_json(const boost::json::object& report, const char* table, const char* name) {
    NetlistLines lines;
    for (const auto& row : report.at("deadlock").at(table).as_array())
        lines[std::string(row.at(name).as_string())] = row.at("netlist").as_string();
    return lines;
}

/// Returns the last column of each row of the text report's table whose head begins with `name`.
NetlistLines lines_in_text(const std::string& report, const std::string& name) {
    NetlistLines lines;
    std::istringstream text(report.substr(report.find("\n" + name + " ") + 1));
    std::string head, row;
    std::getline(text, head);
    const std::size_t column = head.find("netlist");
    REQUIRE(column != std::string::npos);
    while (std::getline(text, row) && !row.empty())
        lines[row.substr(0, row.find("  "))] = row.substr(column);
    return lines;
}

} // namespace

TEST_CASE("a deadlock's processes and channels are printed with the lines that declare them") {
    ProblemRegistry problems = known_problems(1);
    Catalogue catalogue = known_kinds(problems);
    ReadResult read = read_netlist_text(buffers_and_a_consumer, catalogue, {}, "folder/stuck.cfs");
    INFO(render(read.diagnostics));
    REQUIRE(read.network);
    RunReport report = Machine(*read.network, catalogue, 1).run();
    REQUIRE(report.result.ending == Ending::stuck);
    const NetlistLines processes{{"a", "stuck.cfs:4"}, {"b", "stuck.cfs:5"}, {"c", "stuck.cfs:6"}};
    const NetlistLines channels{
        {"a.out -> b.in", "stuck.cfs:14"}, {"b.out -> a.in", "stuck.cfs:15"}, {"d.out -> c.in", "stuck.cfs:15"}};
    auto json = report_json(report, *read.network, {.command = "", .seed = 1, .overrides = {}});
    CHECK(lines_in_json(json, "processes", "process") == processes);
    CHECK(lines_in_json(json, "channels", "channel") == channels);
    std::string text = print_report(report, *read.network);
    INFO(text);
    CHECK(lines_in_text(text, "process") == processes);
    CHECK(lines_in_text(text, "channel") == channels);
}

TEST_CASE("a deadlock of processes without a netlist is printed without lines") {
    Deadlock deadlock{.cycle = {"a"},
                      .held_up = {},
                      .processes = {{"a", Activity::inputting, {"c"}, "here.cpp:1"}},
                      .channels = {{"c", "a", "a", "inputter"}}};
    CHECK(deadlock.text().find("netlist") == std::string::npos);
    deadlock.processes.front().netlist = "n.cfs:7";
    CHECK(deadlock.text().find("here.cpp:1               n.cfs:7\n") != std::string::npos);
    CHECK(deadlock.text().find("waiting   netlist") == std::string::npos); // each table has its own columns
}

TEST_CASE("the report of a run names the processes that never ran") {
    ProblemRegistry problems = known_problems(1);
    Catalogue catalogue = known_kinds(problems);
    ReadResult read = read_netlist_text(
        "T800 t; highprocess p, c; process q, d; use \"csp.producer\" for p; use \"csp.consumer\" for c;"
        "use \"csp.producer\" for q; use \"csp.consumer\" for d; p (cycles = 1000);"
        "connect p.out to c.in; connect q.out to d.in;"
        "place p on t; place c on t; place q on t; place d on t;",
        catalogue);
    INFO(render(read.diagnostics));
    REQUIRE(read.network);
    RunReport report = Machine(*read.network, catalogue, 1).run(std::chrono::milliseconds{1});
    CHECK(print_report(report, *read.network).find("\nnever ran: q, d\n") != std::string::npos);
    auto json = report_json(report, *read.network, {.command = "", .seed = 1, .overrides = {}});
    CHECK(json.at("never_ran") == boost::json::array{"q", "d"});
    RunReport all = Machine(*read.network, catalogue, 1).run();
    CHECK(print_report(all, *read.network).find("never ran") == std::string::npos);
    for (int i = 0; i < 12; ++i)
        report.result.never_ran.push_back("r" + std::to_string(i));
    CHECK(print_report(report, *read.network).find(", r9 and 2 others\n") != std::string::npos);
    report.result.never_ran.pop_back();
    CHECK(print_report(report, *read.network).find(", r9 and 1 other\n") != std::string::npos);
}

TEST_CASE("only processes in the deadlock are reported as waiting for ever, not processes after their work") {
    ProblemRegistry problems = known_problems(1);
    Catalogue catalogue = known_kinds(problems);
    ReadResult read = read_netlist_text(farm_beside_a_deadlock, catalogue);
    INFO(render(read.diagnostics));
    REQUIRE(read.network);
    RunReport report = Machine(*read.network, catalogue, 1).run();
    CHECK(report.result.ending == Ending::stuck);
    for (const ProcessUse& process : report.processes) {
        CAPTURE(process.name);
        CHECK(process.waits_since.has_value() == (process.name == "consumer"));
    }
}
