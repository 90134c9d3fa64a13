// Tests that a run is read back from its report, and that other files are refused.

#include "explore/compare/comparison.hpp"

#include "netlist/network/network.hpp"
#include "report/manifest.hpp"
#include "tests/scratch.hpp"
#include "text/user_error.hpp"

#include <boost/json.hpp>
#include <doctest/doctest.h>

#include <string>

using namespace placedpar;

namespace {

const std::string chain_of_n = "rep i = 0 for n - 1\n    connect t[i].link[0] to t[i + 1].link[1];\n";

/// A netlist in a file, and the report of a run of it.
class ReportedNetlist {
public:
    ReportedNetlist() { write_report({.command = "run", .seed = 7, .overrides = {{"n", "3"}}}); }

    void write_netlist(const std::string& text) { netlist_ = folder_.write("n.cfs", text); }
    void write_report(const Manifest& manifest) {
        const Network network = load_compared({.name = "", .parsed = ParsedNetlist(netlist_), .set = {{"n", "3"}}});
        folder_.write("run.json", print_pretty(boost::json::object{{"manifest", manifest_json(manifest, network)}}));
    }
    ComparedRun read() {
        return run_of_report((folder_ / "run.json").string(), [this](const std::string& text) { warnings += text; });
    }
    std::string path() const { return (folder_ / "run.json").string(); }
    std::string netlist() const { return netlist_.string(); }

    std::string warnings;

private:
    Scratch folder_;
    std::filesystem::path netlist_ = folder_.write("n.cfs", "val n 2;\nT800 t[n];\n" + chain_of_n);
};

} // namespace

TEST_CASE("a report gives the run's netlist, settings and seed") {
    ReportedNetlist reported;
    const ComparedRun run = reported.read();
    CHECK(reported.warnings == "");
    CHECK(run.name == reported.path());
    CHECK(run.seed == 7);
    CHECK(run.set == Overrides{{"n", "3"}});
    CHECK(run.until == Time::max());
    CHECK_FALSE(run.shuffle);
    CHECK(load_compared(run).nodes.size() == 3);
}

TEST_CASE("the limits and the order of processes of the reported run are kept") {
    ReportedNetlist reported;
    reported.write_report({.command = "run", .seed = 1, .overrides = {{"n", "3"}}, .until = Time{12345}, .shuffle = 0});
    const ComparedRun run = reported.read();
    CHECK(run.until == Time{12345});
    CHECK(run.shuffle == 0);
}

TEST_CASE("a netlist that has changed since is used, with a warning") {
    ReportedNetlist reported;
    reported.write_netlist("val n 2;\nT414 t[n];\n" + chain_of_n);
    CHECK(load_compared(reported.read()).nodes.front().type == "T414");
    CHECK(reported.warnings == reported.path() + ": warning: " + reported.netlist() +
                                   " has changed since this run; the new netlist is compared\n");
    reported.write_netlist("T800 t;\n"); // without the constant that the run set
    CHECK_THROWS_AS(reported.read(), RefusedInput);
}

TEST_CASE("files that are not reports are refused with a hint") {
    const Scratch folder;
    for (const char* text : {"", "{", "[]", "3", "{}", R"({"manifest": 3})", R"({"manifest": {"netlist": "n.cfs"}})",
                             R"({"manifest": {"netlist": 5, "overrides": {}, "seed": 1}})", "\xff"}) {
        CAPTURE(text);
        const std::string path = folder.write("bad.json", text).string();
        CHECK_THROWS_AS(run_of_report(path, [](const std::string&) {}), UserError);
    }
    const std::string path = folder.write("bad.json", "{}").string();
    CHECK_THROWS_WITH_AS(run_of_report(path, [](const std::string&) {}),
                         (path + ": expected a report that placedpar run --json wrote").c_str(), UserError);
}
