// Tests the file of a trace: its format, and the message about omissions.

#include "on_one_node.hpp"

#include "observe/trace/trace_file.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>

using namespace placedpar;
using namespace std::chrono_literals;
using test::on_one_node;

namespace {

/// A file of this name, deleted afterwards.
struct Written {
    explicit Written(const std::string& name) : path(std::filesystem::temp_directory_path() / name) {}
    ~Written() { std::filesystem::remove(path); }
    /// Traces a process that waits ten times for a microsecond. Returns the message about the trace.
    std::string run(const TraceWindow& window = {}) const {
        Simulation simulation;
        TraceFile file(path, on_one_node({"p"}), window);
        simulation.trace_to(file.sink());
        simulation.process("p", [] {
            for (int i = 0; i < 10; ++i)
                wait_for(1us);
        });
        return file.finish(simulation.run());
    }
    std::string first_line() const {
        std::string line;
        std::ifstream file(path);
        std::getline(file, line);
        return line;
    }
    std::filesystem::path path;
};

} // namespace

TEST_CASE("the suffix of the name, in either case, gives the format") {
    Written json("placedpar_trace_file_test.JSON"), vcd("placedpar_trace_file_test.vcd");
    CHECK(json.run().empty());
    CHECK(json.first_line() == R"({"displayTimeUnit":"ns","traceEvents":[)");
    CHECK(vcd.run().empty());
    CHECK(vcd.first_line() == "$version PlacedPar $end");
}

TEST_CASE("another suffix is refused before writing, but standard output is accepted") {
    CHECK_THROWS_AS(require_trace_format("trace.txt"), UserError);
    CHECK_THROWS_AS(Written("placedpar_trace_file_test.txt").run(), UserError);
    CHECK_NOTHROW(require_trace_format("-"));
}

TEST_CASE("an empty window is refused") {
    Written file("placedpar_trace_file_test.json");
    CHECK_THROWS_WITH_AS(file.run({.from = 2us, .until = 2us}),
                         "the trace would begin at 2.000000 us but end at 2.000000 us: choose a later end", UserError);
    CHECK_FALSE(std::filesystem::exists(file.path));
}

TEST_CASE("the parts missing in the trace are reported") {
    Written file("placedpar_trace_file_test.json");
    std::string full = file.run({.most_entries = 3});
    CHECK(full.find("the trace is full and ends at 3.000000 us, after 3 entries") != std::string::npos);
    std::string empty = file.run({.from = 20us});
    CHECK(empty.find("the trace is empty: the run ended at 10.000000 us") != std::string::npos);
    CHECK(file.run({.from = 2us, .until = 5us}).empty());
}
