// Tests jobs that run a graph of tasks: their times, their netlists, and the refusals of wrong tables.

#include "explore/generate/task_graph.hpp"

#include "explore/generate/generate.hpp"
#include "explore/generate/topology.hpp"
#include "explore/netlist_run.hpp"
#include "explore/problems.hpp"
#include "netlist/read.hpp"
#include "tests/nearly.hpp"
#include "tests/scratch.hpp"
#include "text/refused_text.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

using namespace placedpar;
using namespace placedpar::generate;

namespace {

TopologyRequest ring_of_three() {
    TopologyRequest request;
    request.topology = "ring";
    request.size = "3";
    return request;
}

Job job_of_table(const std::string& table) {
    const Scratch folder;
    return tasks_of_file(folder.write("tasks.csv", table).string(), 3, topology_of(ring_of_three()));
}

/// Returns the places and messages of the refusal: "2:3 message".
std::vector<std::string> task_refusals(const std::string& table) {
    std::vector<std::string> all;
    try {
        job_of_table(table);
    } catch (const RefusedText& refused) {
        for (const Diagnostic& each : refused.diagnostics())
            all.push_back(fmt::format("{}:{} {}", each.location.line, each.location.column, each.message));
    }
    return all;
}

RunReport run_of_tasks(const std::string& table) {
    const Scratch folder;
    TopologyRequest request = ring_of_three();
    request.job = folder.write("tasks.csv", table).string();
    const ProblemRegistry problems = known_problems(1);
    const Catalogue catalogue = known_kinds(problems);
    const ReadResult read = read_netlist_text(generate::generate(request, catalogue).text, catalogue);
    REQUIRE(read.network);
    return run_netlist(*read.network, catalogue, {});
}

using Refusals = std::vector<std::string>;
const std::string task_header = "task,cycles,successors\n", placed_header = "task,cycles,successors,processor\n";

} // namespace

TEST_CASE("a run takes as long as the longest path of its tasks: at 20 MHz, 20000 cycles take 1 ms") {
    // Two branches from a to d: by b (2 ms) and by c (5 ms). The critical path is a, c, d: 1 + 5 + 1 ms.
    const RunReport report = run_of_tasks(placed_header + "a,20000,b:4 c:4,0\nb,40000,d:4,1\nc,100000,d:4,2\n"
                                                          "d,20000,,0\n");
    CHECK(report.result.ending == Ending::completed);
    CHECK(report.measured("task_a", "ready") == doctest::Approx(0).epsilon(.02));
    CHECK(report.measured("task_b", "done") == test::nearly(3, .02));
    CHECK(report.measured("task_c", "done") == test::nearly(6, .02));
    CHECK(report.measured("task_d", "ready") == test::nearly(6, .02));
    CHECK(report.measured("task_d", "done") == test::nearly(7, .02));
}

TEST_CASE("tasks on one processor take as long as their sum, whatever their order") {
    const RunReport report = run_of_tasks(placed_header + "a,20000,b:4 c:4,0\nb,40000,d:4,0\nc,100000,d:4,0\n"
                                                          "d,20000,,0\n");
    CHECK(report.measured("task_d", "done") == test::nearly(1 + 2 + 5 + 1, .02));
}

TEST_CASE("a message of n bytes delays its receiver by at least 11 bits a byte, at 20 Mbit/s") {
    const RunReport report = run_of_tasks(placed_header + "a,0,b:20000,0\nb,0,,1\n");
    const double least_ms = 20000 * 11 / 20e6 * 1000;
    CHECK(report.measured("task_b", "ready") > least_ms);
    CHECK(report.measured("task_b", "ready") < 1.2 * least_ms);
}

TEST_CASE("each task becomes a process, each successor a channel; tasks are assigned to the processors in turn") {
    const Job job = job_of_table(task_header + "a,5,c:8 b:9\nb,6,c:7\nc,0,\nd,1,\n");
    CHECK_FALSE(job.has_host);
    CHECK(job.about.starts_with("A graph of 4 tasks from "));
    for (const char* statement :
         {"task_a (cycles = 5, bytes = \"8 9\");\n", "task_b (cycles = 6, bytes = \"7\");\n",
          "task_c (cycles = 0, bytes = \"\");\n", "connect task_a.out[0] to task_c.in[0];\n",
          "connect task_a.out[1] to task_b.in[0];\n", "connect task_b.out[0] to task_c.in[1];\n",
          "rep i = 2 for 1\n    place task_c on t[i];\n", "rep i = 0 for 1\n    place task_d on t[i];\n"})
        CHECK_MESSAGE(job.statements.find(statement) != std::string::npos, statement);
}

TEST_CASE("columns may come in any order, with other columns between them; an empty processor is chosen in turn") {
    const Job job = job_of_table("notes,processor,successors,cycles,task\nfirst,2,b:1,10,a\n,,,20,b\n");
    CHECK(job.statements.find("rep i = 2 for 1\n    place task_a") != std::string::npos);
    CHECK(job.statements.find("rep i = 1 for 1\n    place task_b") != std::string::npos);
    CHECK(job.statements.find("task_b (cycles = 20,") != std::string::npos);
}

TEST_CASE("a table without the needed columns or tasks is refused") {
    CHECK(task_refusals("task,cycle\na,1\n") ==
          Refusals{"1:1 the table has no column \"cycles\"", "1:1 the table has no column \"successors\""});
    CHECK(task_refusals(task_header) == Refusals{"0:0 expected a header and 1 to 100000 tasks"});
    CHECK(task_refusals("") == Refusals{"0:0 expected a header and 1 to 100000 tasks"});
}

TEST_CASE("the limits of names, cycles, bytes and processors are accepted, and what exceeds them is refused") {
    const std::string longest(60, 'n');
    CHECK(task_refusals(placed_header + longest + ",1000000000000,b:1000000000,2\nb,0,,\n").empty());
    CHECK(task_refusals(placed_header + longest + "n,1,,\n") ==
          Refusals{"2:1 \"" + longest + "n\" cannot be the name of a task"});
    CHECK(task_refusals(placed_header + "a,1000000000001,,\n") ==
          Refusals{"2:3 \"1000000000001\" is not a number of cycles"});
    for (const char* word : {"b:1000000001", "b:0", "b:-1", "b:", "b", "b:1.5", "b:99999999999"})
        CHECK(task_refusals(placed_header + "a,1," + word + ",\nb,1,,\n") ==
              Refusals{fmt::format("2:5 \"{}\" does not state a number of bytes", word)});
    CHECK(task_refusals(placed_header + "a,1,,3\n") == Refusals{"2:6 \"3\" is not a processor of this machine"});
}

TEST_CASE("a task that is listed twice, and an unknown successor, are refused by name") {
    CHECK(task_refusals(task_header + "a,1,\na,2,\n") == Refusals{"3:1 the task \"a\" is listed twice"});
    const Refusals unknown = task_refusals(task_header + "filter,1,\nb,1,filtre:4\n");
    REQUIRE(unknown.size() == 1);
    CHECK(unknown[0].starts_with("3:5 unknown task \"filtre\""));
    CHECK(unknown[0].find("did you mean \"filter\"?") != std::string::npos);
}

TEST_CASE("tasks in a circle are refused, also a task that needs itself; two paths to one task are no circle") {
    CHECK(task_refusals(task_header + "a,1,a:4\n") ==
          Refusals{"2:1 the task \"a\" is in a circle of tasks, or depends on a task in a circle"});
    CHECK(task_refusals(task_header + "s,1,a:4\na,1,b:4\nb,1,c:4\nc,1,a:4\n") ==
          Refusals{"3:1 the task \"a\" is in a circle of tasks, or depends on a task in a circle"});
    CHECK(task_refusals(task_header + "a,1,b:4 c:4 d:4\nb,1,d:4\nc,1,d:4\nd,1,\n").empty());
}

TEST_CASE("at most twenty faults of a table are shown") {
    std::string table = task_header;
    for (int i = 0; i < 30; ++i)
        table += fmt::format("t{},x,\n", i);
    CHECK(task_refusals(table).size() == 20);
}
