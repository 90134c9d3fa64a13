// Tests the check of files in all languages: what it says about a file without errors, where it finds errors, and its
// form as JSON.

#include "explore/check/check_file.hpp"

#include "explore/problems.hpp"
#include "tests/scratch.hpp"

#include <boost/json.hpp>
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <vector>

using namespace placedpar;

namespace {

CheckedFile checked(const std::filesystem::path& path, const CheckOptions& options = {}) {
    const ProblemRegistry problems = known_problems(1);
    return check_file(path, known_kinds(problems), options);
}

/// Returns the diagnostics as "2:3 message"; "message" if a diagnostic has no line.
std::vector<std::string> places_of(const CheckedFile& file) {
    std::vector<std::string> all;
    for (const Diagnostic& each : file.diagnostics)
        all.push_back(each.location.line == 0
                          ? each.message
                          : fmt::format("{}:{} {}", each.location.line, each.location.column, each.message));
    return all;
}

using ErrorPlaces = std::vector<std::string>;

constexpr const char* two_nodes = "T800 a, b;\nconnect a.link[0] to b.link[1];\n";
constexpr const char* study_of_clocks = "netlist = \"two.cfs\"\n[set]\nclock = [\"10M\", \"20M\", \"25M\"]\n";

} // namespace

TEST_CASE("a netlist without errors is summarised by its processors, connections, processes and channels") {
    const Scratch folder;
    const auto path = folder.write("two.cfs", std::string(two_nodes) +
                                                  "process p, c; use \"csp.producer\" for p; use \"csp.consumer\" for "
                                                  "c; place p on a; place c on b; connect p.out to c.in;\n");
    const CheckedFile file = checked(path);
    CHECK(file.language == "netlist");
    CHECK_FALSE(file.failed());
    CHECK(file.diagnostics.empty());
    CHECK(file.summary.starts_with(path.string() + ": 2 processors, 1 connection, 2 processes, 1 channel; hash "));
    CHECK(file.names == NamesOf::netlist);
}

TEST_CASE("an error of a netlist has its place, and the file has no summary") {
    const Scratch folder;
    const CheckedFile file = checked(folder.write("bad.cfs", "T800 a, a;\n"));
    CHECK(file.failed());
    CHECK(file.summary == "");
    REQUIRE(file.diagnostics.size() == 1);
    CHECK(file.diagnostics[0].location.line == 1);
    CHECK(file.diagnostics[0].location.column == 9);
}

TEST_CASE("a netlist that declares nothing is an error of the whole file") {
    const Scratch folder;
    const CheckedFile file = checked(folder.write("empty.cfs", "/* nothing yet */\nval n 3;\n"));
    CHECK(file.failed());
    CHECK(places_of(file) == ErrorPlaces{"the netlist is empty"});
}

TEST_CASE("settings change what is checked") {
    const Scratch folder;
    const auto path = folder.write(
        "n.cfs", "val n 2;\nT800 t[n];\nrep i = 0 for n - 1\n    connect t[i].link[0] to t[i + 1].link[1];\n");
    CHECK(checked(path, {.set = {{"n", "3"}}}).summary.find("3 processors") != std::string::npos);
    CHECK(checked(path, {.set = {{"n", "-1"}}}).failed());
    CHECK(checked(path, {.set = {{"m", "1"}}}).failed());
}

TEST_CASE("included files are listed, also if an error is in one of them") {
    const Scratch folder;
    folder.write("good.inc", "T800 a;\n");
    folder.write("bad.inc", "T800 a\n");
    const CheckedFile good = checked(folder.write("g.cfs", "#include \"good.inc\"\n")),
                      bad = checked(folder.write("b.cfs", "#include \"bad.inc\"\n"));
    CHECK_FALSE(good.failed());
    CHECK(good.included == std::vector{(folder / "good.inc").string()});
    CHECK(bad.failed());
    CHECK(bad.included == std::vector{(folder / "bad.inc").string()});
}

TEST_CASE("a file that does not exist is an error of the check, not an exception") {
    const Scratch folder;
    for (const char* name : {"none.cfs", "none.occ", "none.toml"}) {
        CAPTURE(name);
        const CheckedFile file = checked(folder / name);
        CHECK(file.failed());
        CHECK(file.summary == "");
    }
}

TEST_CASE("a program's summary says which procedure would be run") {
    const Scratch folder;
    const auto summary_of = [&](const std::string& text) {
        const CheckedFile file = checked(folder.write("p.occ", text));
        CHECK(file.language == "occam");
        CHECK(places_of(file) == ErrorPlaces{});
        return file.summary.substr(file.summary.find(": ") + 2);
    };
    CHECK(summary_of("PROC first ()\n  SKIP\n:\nPROC last ()\n  first ()\n:\n") ==
          "no errors; PROC last would be run\n");
    CHECK(summary_of("PROC p (INT x)\n  x := 1\n:\n") ==
          "no errors; only a netlist can use PROC p, because of its parameters\n");
    CHECK(summary_of("VAL n IS 3:\n") == "no errors; the file has no procedure\n");
}

TEST_CASE("errors of a program have their places; a check that is turned off finds nothing") {
    const Scratch folder;
    const std::string races = "PROC p ()\n  INT x:\n  PAR\n    x := 1\n    x := 2\n:\n";
    const auto path = folder.write("p.occ", races);
    const CheckedFile strict = checked(path), lenient = checked(path, {.program = {.usage_checks = false}});
    REQUIRE(strict.diagnostics.size() == 1);
    CHECK(strict.diagnostics[0].location.line == 5);
    CHECK(strict.names == NamesOf::occam);
    CHECK_FALSE(lenient.failed());
}

TEST_CASE("the library's files are not among the files that a program includes") {
    const Scratch folder;
    folder.write("mine.inc", "VAL n IS 3:\n");
    const CheckedFile file = checked(folder.write("p.occ", "#INCLUDE \"hostio.inc\"\n#INCLUDE \"mine.inc\"\n"
                                                           "PROC p ()\n  SKIP\n:\n"));
    CHECK(file.included == std::vector{(folder / "mine.inc").string()});
}

TEST_CASE("a study is known by its name in any case, and summarised by its number of runs") {
    const Scratch folder;
    folder.write("two.cfs", two_nodes);
    CHECK(is_study("a.toml"));
    CHECK(is_study("A.TOML"));
    CHECK_FALSE(is_study("toml"));
    CHECK_FALSE(is_study("a.toml.txt"));
    const auto path = folder.write("s.toml", std::string("seeds = 2\n") + study_of_clocks);
    const CheckedFile file = checked(path);
    CHECK(file.language == "study");
    CHECK(file.summary == path.string() + ": 6 runs of " + (folder / "two.cfs").string() + "\n");
    CHECK(file.included == std::vector{(folder / "two.cfs").string()});
}

TEST_CASE("a study's netlist is checked with the first combination for which the condition holds") {
    const Scratch folder;
    folder.write("two.cfs", "val n 0;\nT800 t[n];\nif n == 2\n    T800 t;\n"); // t is declared twice if n is 2
    const std::string axis = "netlist = \"two.cfs\"\n[set]\nn = \"0..3\"\n";
    const CheckedFile first = checked(folder.write("a.toml", "where = \"n > 0\"\n" + axis)),
                      second = checked(folder.write("b.toml", "where = \"n > 1\"\n" + axis));
    CHECK(places_of(first) == ErrorPlaces{});
    REQUIRE(second.diagnostics.size() == 1);
    CHECK(second.diagnostics[0].location.file->path() == (folder / "two.cfs").string());
    CHECK(second.diagnostics[0].location.line == 4);
}

TEST_CASE("a fault of a study is in the study; a missing netlist is one, too") {
    const Scratch folder;
    const auto path = folder.write("s.toml", study_of_clocks);
    const CheckedFile missing = checked(path);
    REQUIRE(missing.diagnostics.size() == 1);
    CHECK(missing.diagnostics[0].location.file->path() == path.string());
    CHECK(missing.diagnostics[0].message.starts_with((folder / "two.cfs").string() + ": "));
    CHECK(missing.summary == "");
    const CheckedFile odd = checked(folder.write("odd.toml", "netlist = \"two.cfs\"\nseedz = 3\n"));
    REQUIRE(odd.diagnostics.size() == 1);
    CHECK(odd.diagnostics[0].location.line == 2);
    CHECK(odd.language == "study");
}

TEST_CASE("a diagnostic as JSON has its place from the first character to the one after the last, and related places") {
    const Scratch folder;
    const auto path = folder.write("bad.cfs", "T800 node, other, node;\n");
    const CheckedFile file = checked(path);
    const boost::json::object json = checked_json(path, file);
    CHECK(json.at("file") == boost::json::string(path.string()));
    CHECK(json.at("language") == "netlist");
    CHECK(json.at("valid") == false);
    CHECK(json.at("summary") == "");
    CHECK(json.at("not_shown") == "");
    REQUIRE(json.at("diagnostics").as_array().size() == 1);
    const boost::json::object& fault = json.at("diagnostics").at(0).as_object();
    CHECK(fault.at("severity") == "error");
    CHECK(fault.at("line") == 1);
    CHECK(fault.at("column") == 19);
    CHECK(fault.at("end_line") == 1);
    CHECK(fault.at("end_column") == 23);
    REQUIRE(fault.at("also").as_array().size() == 1);
    const boost::json::object& earlier = fault.at("also").at(0).as_object();
    CHECK(earlier.at("column") == 6);
    CHECK(earlier.at("end_column") == 10);
    CHECK_FALSE(earlier.contains("severity"));
}

TEST_CASE("as JSON a fault of a whole file has no line, and a valid file has a summary of one line") {
    const Scratch folder;
    const auto empty = folder.write("empty.cfs", "");
    const boost::json::object fault = checked_json(empty, checked(empty)).at("diagnostics").at(0).as_object();
    CHECK_FALSE(fault.contains("line"));
    CHECK(fault.at("also").as_array().empty());
    const auto good = folder.write("two.cfs", two_nodes);
    const boost::json::object json = checked_json(good, checked(good));
    CHECK(json.at("valid") == true);
    CHECK(std::string(json.at("summary").as_string()).find('\n') == std::string::npos);
    CHECK(json.at("diagnostics").as_array().empty());
}

TEST_CASE("of more than twenty errors the others are counted") {
    const Scratch folder;
    std::string text;
    for (int i = 0; i < 25; ++i)
        text += fmt::format("connect a{0}.link[0] to b{0}.link[0];\n", i);
    const auto path = folder.write("many.cfs", text);
    const boost::json::object json = checked_json(path, checked(path));
    CHECK(json.at("diagnostics").as_array().size() == 20);
    CHECK(std::string(json.at("not_shown").as_string()).starts_with("... "));
}
