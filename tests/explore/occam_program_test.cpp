// Tests how a program in occam is compiled and becomes a netlist with one transputer.

#include "explore/occam_program.hpp"

#include "explore/load.hpp"
#include "explore/occam_check.hpp"
#include "explore/problems.hpp"
#include "tests/scratch.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <memory>
#include <string>

using namespace placedpar;

namespace {

void quiet(const std::string&) {}

/// Returns whether a program whose last procedure has these parameters can be run.
bool runs_with(const std::string& parameters) {
    const OccamCheck program =
        check_occam_source(std::make_shared<const SourceFile>("p.occ", "#INCLUDE \"hostio.inc\"\nPROC p (" +
                                                                           parameters + ")\n  SKIP\n:\n"),
                           {});
    REQUIRE_FALSE(program.failed);
    REQUIRE(program.main);
    return can_be_run(*program.main);
}

OccamCheck check_of(const std::string& text, const occam::SourceOptions& wanted = {}) {
    return check_occam_source(std::make_shared<const SourceFile>("p.occ", text), {}, wanted);
}

Network network_of_program(const std::filesystem::path& path, const ProgramMachine& machine,
                           const Overrides& set = {}) {
    return load_network(path, set, known_problems(1), quiet, {.make_netlist = netlist_maker(machine)});
}

constexpr const char* does_nothing = "PROC p ()\n  SKIP\n:\n";
constexpr const char* two_writers = "PROC p ()\n  INT x:\n  PAR\n    x := 1\n    x := 2\n:\n";

} // namespace

TEST_CASE("a size is a whole number of bytes, of K or of M; very large sizes do not overflow") {
    CHECK(bytes_of_size("0") == 0);
    CHECK(bytes_of_size("4096") == 4096);
    CHECK(bytes_of_size("32K") == 32768);
    CHECK(bytes_of_size("2M") == 2097152);
    CHECK(bytes_of_size("18446744073709551615M") >= std::uint64_t{1} << 32);
    for (const char* text : {"", "K", "M", "-1", "1.5M", "2 M", "2m", "2k", "2MM", "2G", "18446744073709551616"})
        CHECK_FALSE(bytes_of_size(text));
}

TEST_CASE("a program with no parameters, a terminal, or channels to a host can be run") {
    CHECK(runs_with(""));
    CHECK(runs_with("CHAN OF SP fs, ts"));
    CHECK(runs_with("CHAN OF SP fs, ts, []INT memory"));
    CHECK(runs_with("CHAN OF BYTE keyboard, screen, error"));
    for (const char* parameters :
         {"INT x", "VAL INT x", "CHAN OF SP fs, ts, INT x", "CHAN OF SP fs, ts, []BYTE memory",
          "CHAN OF SP fs, ts, [4]INT memory", "[]INT memory", "CHAN OF INT a, b, c, d", "CHAN OF SP fs, []INT memory"})
        CHECK_FALSE_MESSAGE(runs_with(parameters), parameters);
}

TEST_CASE("programs are known by their names; a configuration is none") {
    CHECK(is_occam("p.occ"));
    CHECK(is_occam("folder/p.occ"));
    for (const char* name : {"p.OCC", "p.cfs", "occ", ".occ", "p.occ.txt", ""})
        CHECK_FALSE_MESSAGE(is_occam(name), name);
}

TEST_CASE("checks are turned off by name, several with commas") {
    CHECK(wanted_checks({}).usage_checks);
    const occam::SourceOptions two = wanted_checks({.no_checks = "usage,range"});
    CHECK_FALSE(two.usage_checks);
    CHECK_FALSE(two.range_checks);
    CHECK(two.alias_checks);
    CHECK(two.run_time_checks);
    CHECK_FALSE(wanted_checks({.no_checks = "all"}).run_time_checks);
    for (const char* wrong : {"usages", "usage,,range", ",", "usage range", "Usage"})
        CHECK_THROWS_WITH_AS(wanted_checks({.no_checks = wrong}),
                             doctest::Contains("is not the name of a check: the names are usage, alias, range and all"),
                             UserError);
}

TEST_CASE("a netlist can leave out only the checks at run time of its programs") {
    CHECK(choices_of({.mode = "stop"}).mode == "stop");
    CHECK(choices_of({}).range_checks);
    CHECK_FALSE(choices_of({.no_checks = "range"}).range_checks);
    CHECK_FALSE(choices_of({.no_checks = "all"}).range_checks);
    CHECK_THROWS_WITH_AS(choices_of({.no_checks = "usage"}), doctest::Contains("write #OPTION \"N\" into the file"),
                         UserError);
    CHECK_THROWS_WITH_AS(choices_of({.no_checks = "alias"}), doctest::Contains("write #OPTION \"A\" into the file"),
                         UserError);
}

TEST_CASE("the caller and the text can each turn a check off") {
    CHECK(check_of(two_writers).failed);
    CHECK_FALSE(check_of(two_writers, {.usage_checks = false}).failed);
    CHECK_FALSE(check_of(std::string("#OPTION \"N\"\n") + two_writers).failed);
}

TEST_CASE("the main procedure is the last of the file; a file without one, or with an error, says so") {
    REQUIRE(check_of("PROC a ()\n  SKIP\n:\nPROC b ()\n  SKIP\n:\n").main);
    CHECK(check_of("PROC a ()\n  SKIP\n:\nPROC b ()\n  SKIP\n:\n").main->name == "b");
    CHECK(check_of("VAL n IS 3:\n").main == nullptr);
    CHECK(check_of("").main == nullptr);
    const OccamCheck wrong = check_of("PROC p ()\n  x := 1\n:\n");
    CHECK(wrong.failed);
    REQUIRE(wrong.diagnostics.size() == 1);
    CHECK(wrong.diagnostics[0].location.line == 2);
}

TEST_CASE("the netlist around a program has the transputer, its memory, and the host") {
    const ProgramMachine machine{.processor = "T414", .memory = "1M", .memory_cycles = 5};
    CHECK(netlist_around("folder/p.occ", machine) == "T414 (memory = 1M, memorycycles = 5) root;\n"
                                                     "connect root.link[0] to host;\nuse \"p.occ\" for root;\n");
    const ProgramMachine stops{.occam = {.mode = "stop"}};
    CHECK(netlist_around("p.occ", stops).find("wraps = 1") != std::string::npos);
    CHECK(netlist_around("p.btl", stops).find("wraps = 1") == std::string::npos);
}

TEST_CASE("a compiled program states its memory, with 8 bytes or more for each of its variables") {
    const Scratch folder;
    const auto memory = [&](const std::string& text) {
        return compile_occam(folder.write("p.occ", text), {}, {}, transputer::Model::t800, quiet).memory_bytes;
    };
    const std::uint64_t small = memory("PROC p ()\n  [10]INT v:\n  v[0] := 1\n:\n"),
                        large = memory("PROC p ()\n  [1010]INT v:\n  v[0] := 1\n:\n");
    CHECK(large - small == 4000); // 1000 words of 4 bytes
}

TEST_CASE("what cannot be compiled is refused: errors, configurations, files without a procedure, missing files") {
    const Scratch folder;
    const auto compile = [&](const std::string& text, const OccamOptions& options = {}) {
        return compile_occam(folder.write("p.occ", text), {}, options, transputer::Model::t800, quiet);
    };
    CHECK_FALSE(compile(does_nothing).file.empty());
    CHECK_THROWS_WITH_AS(compile("PROC p ()\n  x := 1\n:\n"), doctest::Contains("p.occ:2:3: error: "), RefusedInput);
    CHECK_THROWS_WITH_AS(compile("VAL n IS 3:\n"), doctest::Contains("the file has no PROC that can be run"),
                         UserError);
    CHECK_THROWS_AS(compile(two_writers), RefusedInput);
    CHECK_FALSE(compile(two_writers, {.no_checks = "usage"}).file.empty());
    CHECK_THROWS_AS(compile(does_nothing, {.no_checks = "none"}), UserError);
    CHECK_THROWS_AS(compile_occam(folder / "none.occ", {}, {}, transputer::Model::t800, quiet), RefusedInput);
}

TEST_CASE("a program needs the memory of its transputer; the message says how much would do") {
    const Scratch folder;
    const auto path = folder.write("p.occ", "PROC p ()\n  [300000]INT v:\n  v[0] := 1\n:\n"); // 1.2 Mbyte
    CHECK_NOTHROW(network_of_program(path, {.memory = "2M"}));
    CHECK_THROWS_WITH_AS(network_of_program(path, {.memory = "1M"}),
                         doctest::Contains("bytes of memory, but the transputer has 1M\nhint: use --memory 2M"),
                         UserError);
}

TEST_CASE("an option sets a VAL at the outermost level of a program") {
    const Scratch folder;
    const auto path = folder.write("p.occ", "VAL n IS 10:\nPROC p ()\n  [n]INT v:\n  v[0] := 1\n:\n");
    CHECK_NOTHROW(network_of_program(path, {.memory = "1M"}, {{"n", "20"}}));
    CHECK_THROWS_WITH_AS(network_of_program(path, {.memory = "1M"}, {{"n", "300000"}}),
                         doctest::Contains("but the transputer has 1M"), UserError);
    CHECK_THROWS_AS(network_of_program(path, {}, {{"m", "1"}}), RefusedInput);
}
