// Tests how a study's file is read: its keys, the order of its runs, and the place of each error.

#include "explore/study/study_file.hpp"

#include "explore/study/study.hpp"
#include "tests/scratch.hpp"
#include "text/refused_text.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace placedpar;

namespace {

Study study_of_text(const std::string& text) {
    const Scratch folder;
    return read_study(folder.write("s.toml", text).string());
}

/// Returns the errors as "2:3 message".
std::vector<std::string> errors_of_study(const std::string& text) {
    std::vector<std::string> all;
    try {
        study_of_text(text);
    } catch (const RefusedText& refused) {
        for (const Diagnostic& each : refused.diagnostics())
            all.push_back(fmt::format("{}:{} {}", each.location.line, each.location.column, each.message));
    }
    return all;
}

/// Checks that the lines below a correct first line have exactly this error.
void check_error(const std::string& lines, const std::string& error) {
    CAPTURE(lines);
    CHECK(errors_of_study("netlist = \"n.cfs\"\n" + lines) == std::vector{error});
}

std::vector<std::string> settings_of_runs(const Study& study) {
    std::vector<std::string> all;
    for (std::uint64_t i = 0; i < study.count(); ++i)
        if (const auto run = study.at(i)) {
            std::string text;
            for (const auto& [name, value] : run->set)
                text += name + "=" + value + " ";
            all.push_back(fmt::format("{}#{}", text, run->seed));
        }
    return all;
}

using Lines = std::vector<std::string>;

} // namespace

TEST_CASE("the shortest study runs its netlist once, with seed 1") {
    const Study study = study_of_text("netlist = \"n.cfs\"\n");
    CHECK(settings_of_runs(study) == Lines{"#1"});
    CHECK(study.until == Time::max());
    CHECK(study.measures.empty());
    CHECK_FALSE(study.search);
}

TEST_CASE("paths are relative to the study's folder, also through other folders") {
    const Scratch folder;
    const Study study =
        read_study(folder.write("s.toml", "netlist = \"../n.cfs\"\ninclude = [\"a\", \"/usr/include\"]\n").string());
    const auto folder_path = (folder / "s.toml").parent_path();
    CHECK(study.netlist == (folder_path.parent_path() / "n.cfs").string());
    CHECK(study.read.include_folders == std::vector<std::filesystem::path>{folder_path / "a", "/usr/include"});
}

TEST_CASE("every key of a study has its effect") {
    const Study study =
        study_of_text("netlist = \"n.cfs\"\nseeds = 3\nfirst_seed = 0\nmeasure = [\"time\", \"max(m.T)\"]\n"
                      "until = \"2.5ms\"\nnotes = \"as measured\"\nfault = \"t.link[0] silent\"\n"
                      "use = {\"sim.lku\" = \"ga.master\"}\nprice = {T800 = 300, link = 2.5}\n"
                      "relative_to = {n = 0}\n[set]\nn = [0, 1]\n");
    CHECK(study.seeds == 3);
    CHECK(study.first_seed == 0);
    CHECK(study.measures == Lines{"time", "max(m.T)"});
    CHECK(study.until == Time{2'500'000'000});
    CHECK(study.notes == "as measured");
    CHECK(study.read.faults == Lines{"t.link[0] silent"});
    CHECK(study.read.programs.at("sim.lku") == "ga.master");
    CHECK(study.prices == Prices{{"T800", 300}, {"link", 2.5}});
    CHECK(study.relative_to == Overrides{{"n", "0"}});
    CHECK(study.count() == 6);
}

TEST_CASE("settings vary in the order of the file, the last fastest; values have every form") {
    CHECK(settings_of_runs(study_of_text("netlist = \"n.cfs\"\n[set]\nz = [1, 2]\nb.c = \"5M,10M\"\na = true\n")) ==
          Lines{"a=1 b.c=5M z=1 #1", "a=1 b.c=10M z=1 #1", "a=1 b.c=5M z=2 #1", "a=1 b.c=10M z=2 #1"});
    CHECK(settings_of_runs(study_of_text("netlist = \"n.cfs\"\n[set]\na = \"0..1\"\nb = 2.5\n")) ==
          Lines{"a=0 b=2.5 #1", "a=1 b=2.5 #1"});
    CHECK(settings_of_runs(study_of_text("netlist = \"n.cfs\"\n[set.t]\nclock = \"5M\"\n")) == Lines{"t.clock=5M #1"});
}

TEST_CASE("[[also]] adds combinations, each with its own condition") {
    CHECK(settings_of_runs(study_of_text("netlist = \"n.cfs\"\nwhere = \"a > 1\"\n[set]\na = \"0..3\"\n"
                                         "[[also]]\nset = {a = [7, 8], b = 1}\nwhere = \"a != 7\"\n[[also]]\n")) ==
          Lines{"a=2 #1", "a=3 #1", "a=8 b=1 #1", "#1"});
}

TEST_CASE("a search has one or two different measures and sensible sizes") {
    const std::string head = "netlist = \"n.cfs\"\n[search]\n";
    const Study study =
        study_of_text(head + "minimise = [\"time\", \"price\"]\npopulation = 4\ngenerations = 1\nseed = 0\n");
    REQUIRE(study.search);
    CHECK(study.search->minimise == Lines{"time", "price"});
    CHECK(study.search->population == 4);
    CHECK(study.search->generations == 1);
    CHECK(study.search->seed == 0);
    CHECK(study_of_text(head + "minimise = \"time\"\n").search->minimise == Lines{"time"});
    check_error("[search]\n", "2:1 a search minimises one or two measures");
    check_error("[search]\nminimise = [\"a\", \"b\", \"c\"]\n", "2:1 a search minimises one or two measures");
    check_error("[search]\nminimise = [\"time\", \"time\"]\n", "3:12 \"time\" is named twice in minimise");
    check_error("[search]\nminimise = \"time\"\npopulation = 3\n", "4:14 expected a whole number of at least 4");
    check_error("[search]\nminimise = \"time\"\npopulation = 10001\n", "4:14 expected a whole number of at most 10000");
    check_error("search = 3\n", "2:10 the search must be a single table");
}

TEST_CASE("a study without a netlist is refused") {
    CHECK(errors_of_study("") == Lines{"1:1 the study names no netlist"});
    CHECK(errors_of_study("netlist = \"\"\n").front() == "1:11 expected a text in quotes");
}

TEST_CASE("an unknown key is refused with the key that may be meant") {
    check_error("seedz = 3\n", "2:1 a study has no key \"seedz\"");
    check_error("[search]\nminimise = \"time\"\nminimize = \"time\"\n", "4:1 a search has no key \"minimize\"");
    try {
        study_of_text("netlist = \"n.cfs\"\nseedz = 3\n");
        FAIL("not refused");
    } catch (const RefusedText& refused) {
        CHECK(refused.diagnostics()[0].hint.find("seeds") != std::string::npos);
    }
}

TEST_CASE("a key of the whole study below [[also]] or [set] is said to be misplaced") {
    check_error("[[also]]\nseeds = 3\n", "3:9 \"seeds\" belongs to the whole study, not to this table");
    check_error("[set]\nn = 1\nrelative_to = {n = 1}\n",
                "4:15 \"relative_to\" belongs to the whole study, not to this table");
}

TEST_CASE("values of a wrong type are refused at the value") {
    check_error("seeds = 0\n", "2:9 expected a whole number of at least 1");
    check_error("seeds = \"3\"\n", "2:9 expected a whole number of at least 1");
    check_error("seeds = 3.0\n", "2:9 expected a whole number of at least 1");
    check_error("first_seed = -1\n", "2:14 expected a whole number of at least 0");
    check_error("measure = 3\n", "2:11 expected a text in quotes");
    check_error("fault = [\"a\", 3]\n", "2:15 expected a text in quotes");
    check_error("use = 3\n", "2:7 expected a table of programs and kinds");
    check_error("price = 3\n", "2:9 expected a table of numbers");
    check_error("price = {T800 = -1}\n", "2:17 \"T800\" is not a number from 0 to 1e12");
    check_error("relative_to = 3\n", "2:15 expected a table");
    check_error("relative_to = {n = [1, 2]}\n", "2:15 \"n\" has several values here");
    check_error("set = 3\n", "2:7 expected a table");
    check_error("[set]\nn = []\n", "3:5 \"n\" has no values");
    check_error("[set]\nn = [[1]]\n", "3:6 expected a number or a text");
    check_error("also = 3\n", "2:8 [[also]] must be a table");
}

TEST_CASE("texts that are read further are refused with what is wrong in them") {
    check_error("until = \"3 weeks\"\n", "2:9 \"3 weeks\" is not a time: expected a number and one of the units s, ms, "
                                         "us, ns or ps, such as 2.5ms");
    check_error("measure = \"max(m.T\"\n", errors_of_study("netlist = \"n.cfs\"\nmeasure = \"max(m.T\"\n").at(0));
    const Lines where = errors_of_study("netlist = \"n.cfs\"\nwhere = \"a >\"\n"),
                range = errors_of_study("netlist = \"n.cfs\"\n[set]\na = \"3..1\"\n");
    REQUIRE(where.size() == 1);
    CHECK(where[0].starts_with("2:9 the text cannot be read: "));
    REQUIRE(range.size() == 1);
    CHECK(range[0].starts_with("3:5 a=3..1: the range is empty"));
}

TEST_CASE("a name that is set twice is refused, in either spelling") {
    check_error("[set]\nt.n = 1\n\"t.n\" = 2\n", "4:9 \"t.n\" is set twice");
    CHECK(errors_of_study("netlist = \"n.cfs\"\nseeds = 1\nseeds = 2\n") == Lines{"3:9 \"seeds\" is given twice"});
}

TEST_CASE("relative figures and a search exclude each other") {
    check_error("relative_to = {n = 0}\n[search]\nminimise = \"time\"\n", "2:15 a search cannot use relative figures");
}

TEST_CASE("all errors of a file are reported, in the order of their lines") {
    CHECK(errors_of_study("netlist = \"n.cfs\"\nuntil = \"x\"\nseeds = 0\nfirst = 1\n").size() == 3);
}

TEST_CASE("a text that is not TOML is refused with its line") {
    for (const char* text : {"netlist", "netlist = ", "netlist = \"n\" \"m\"", "= 3", "[set", "\x01"}) {
        const Lines errors = errors_of_study(text);
        REQUIRE_MESSAGE(errors.size() == 1, text);
        CHECK(errors[0].starts_with("1:"));
    }
}
