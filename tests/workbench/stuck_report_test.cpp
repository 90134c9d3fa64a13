// What is said of processes that wait when a run can go no further.

#include "netlist/machine.hpp"
#include "netlist/read.hpp"
#include "workbench/problems.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace placedpar;

namespace {

/// A master and its slave, which rehearse when the work is over, beside a consumer that waits for a sixth packet of
/// five.
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

} // namespace

TEST_CASE("in a deadlock only those that it holds wait for ever, not those that rehearse after the work") {
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
