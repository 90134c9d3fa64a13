// Tests runs whose figures are read from the text that a program prints.

#include "experiments/kit/printing_run.hpp"

#include "experiments/kit/experiment_runs.hpp"
#include "tests/experiments/kit/replay_in_memory.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

using namespace placedpar;

namespace {

/// A folder with one program in occam, deleted at the end.
class OneProgram {
public:
    explicit OneProgram(const std::string& body) {
        std::filesystem::create_directories(folder_);
        std::ofstream(path()) << "#INCLUDE \"hostio.inc\"\n"
                                 "PROC main (CHAN OF SP fs, ts, []INT memory)\n"
                                 "  #USE \"hostio.lib\"\n"
                              << body << ":\n";
    }
    ~OneProgram() { std::filesystem::remove_all(folder_); }
    OneProgram(const OneProgram&) = delete;
    OneProgram& operator=(const OneProgram&) = delete;

    std::filesystem::path path() const { return folder_ / "main.occ"; }

private:
    std::filesystem::path folder_ =
        std::filesystem::temp_directory_path() / fmt::format("placedpar-printing-{}", ::getpid());
};

constexpr const char* prints_a_product = R"(  SEQ
    so.write.string (fs, ts, "6 x 7 = ")
    so.write.int (fs, ts, 6 * 7, 0)
    so.write.nl (fs, ts)
    so.exit (fs, ts, sps.success)
)";

/// This program prints the ticks in which it fills an array in external memory.
constexpr const char* prints_ticks_of_an_array = R"(  [100000]INT array:
  TIMER clock:
  INT from, to:
  SEQ
    clock ? from
    SEQ i = 0 FOR SIZE array
      array[i] := i
    clock ? to
    so.write.string (fs, ts, "ticks: ")
    so.write.int (fs, ts, to MINUS from, 0)
    so.exit (fs, ts, sps.success)
)";

PrintedRun run_program(const OneProgram& program, int memory_cycles = 1) {
    test::ReplayInMemory replay(0);
    return run_occam(program.path(), {.model = transputer::Model::t800}, memory_cycles, replay.context);
}

PrintedRun printed_text(std::string text) { return {std::move(text)}; }

} // namespace

TEST_CASE("the number behind words is the first one after their first place") {
    const PrintedRun run = printed_text("T_exe: 97.0 ms\nT_sr:\n   86.4 ms\nT_exe: 1\nfrom -3e2 to");
    CHECK(run.number_behind("T_exe:") == 97);
    CHECK(run.number_behind("T_sr:") == 86.4); // on the next line
    CHECK(run.number_behind("from") == -300);
    CHECK(run.number_behind("T_exe: 9") == 7); // the words need not end at a space
}

TEST_CASE("without words, or without a number right behind them, the whole output is shown") {
    const PrintedRun run = printed_text("T_exe: none\n");
    for (const char* words : {"T_exe:", "T_sr:", "none\n"})
        CHECK_THROWS_WITH_AS(
            run.number_behind(words),
            fmt::format("the program printed no number after \"{}\"; its whole output is\nT_exe: none\n", words)
                .c_str(),
            UserError);
    CHECK_THROWS_AS(printed_text("").number_behind("T_exe:"), UserError);
}

TEST_CASE("only whole words are numbers of the text") {
    CHECK(printed_text("20015 3453\n").numbers() == std::vector<double>{20015, 3453});
    CHECK(printed_text("a 1 x2 3us 4, 5.5 -6 7e1").numbers() == std::vector<double>{1, 5.5, -6, 70});
    CHECK(printed_text("no digits").numbers().empty());
    CHECK(printed_text("").numbers().empty());
}

TEST_CASE("a program in occam prints its product, and the same run has the same fingerprint") {
    const OneProgram program(prints_a_product);
    const PrintedRun run = run_program(program);
    CHECK(run.text == "6 x 7 = 42\n");
    CHECK(run.number_behind("=") == 42);
    CHECK(run.fingerprint == run_program(program).fingerprint);
    CHECK(run.fingerprint != 0);
}

TEST_CASE("slower external memory makes a program take longer") {
    const OneProgram program(prints_ticks_of_an_array);
    const double at_1 = run_program(program, 1).number_behind("ticks:"),
                 at_3 = run_program(program, 3).number_behind("ticks:"),
                 at_5 = run_program(program, 5).number_behind("ticks:");
    CHECK(at_1 > 500); // 100,000 turns of at least ten cycles, in ticks of 1280 cycles
    // One word of each turn is in external memory, and its access takes two cycles more each time.
    CHECK((at_3 - at_1) * 1280 / 100'000 == doctest::Approx(2).epsilon(0.03));
    CHECK((at_5 - at_3) * 1280 / 100'000 == doctest::Approx(2).epsilon(0.03));
}

TEST_CASE("a program with an error is refused with its line, and a missing file with its name") {
    const OneProgram wrong("  x := 1\n");
    CHECK_THROWS_WITH_AS(run_program(wrong), doctest::Contains("main.occ:4"), RefusedInput);
    test::ReplayInMemory replay(0);
    CHECK_THROWS_WITH_AS(run_occam("no-such-program.occ", {}, 1, replay.context),
                         doctest::Contains("no-such-program.occ"), UserError);
}

TEST_CASE("a program that waits for ever has no figures") {
    const OneProgram waits("  CHAN OF INT c:\n  INT x:\n  c ? x\n");
    CHECK_THROWS_WITH_AS(run_program(waits), doctest::Contains("did not complete"), UnfinishedRun);
}

TEST_CASE("a netlist with a host prints on the screen of the replay, with the settings of the replay") {
    test::ReplayInMemory replay(0);
    const auto cluster = std::filesystem::path(PLACEDPAR_SOURCE_DIR) / "examples/occam/genetic/cluster.cfs";
    const auto time_of = [&](const char* population) {
        return run_printing(cluster, {{"slaves", "0"}, {"generator", "1"}, {"population", population}}, replay.context)
            .number_behind("S_time2");
    };
    CHECK(time_of("120") == doctest::Approx(2 * time_of("60")).epsilon(0.05)); // breeding takes its time individually
    CHECK_THROWS_WITH_AS(time_of("many"), doctest::Contains("population"), RefusedInput);
    replay.interruption.request();
    CHECK_THROWS_AS(time_of("60"), UnfinishedRun);
}
