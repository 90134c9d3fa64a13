// Tests the exercises of the course in occam, and the verdicts on solutions that are run.

#include "explore/exercise/course.hpp"

#include "explore/exercise/student_run.hpp"
#include "explore/load.hpp"
#include "explore/occam_program.hpp"
#include "explore/problems.hpp"
#include "tests/scratch.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>

using namespace placedpar;

namespace {

/// Returns the network of a program with this main process, which may use the library hostio.
Network student_program(const std::string& process) {
    const Scratch folder;
    const auto path = folder.write("mine.occ", "#INCLUDE \"hostio.inc\"\nPROC main (CHAN OF SP fs, ts, []INT memory)\n"
                                               "  #USE \"hostio.lib\"\n" +
                                                   process + ":\n");
    const auto silent = [](const std::string&) {};
    return load_network(path, {}, known_problems(1), silent, {.make_netlist = netlist_maker({})});
}

SolutionVerdict verdict_on(const std::string& process, const std::string& expected) {
    Interruption never;
    return check_solution(student_program(process), {.number = "0.0", .start = "", .expected = expected}, never);
}

constexpr const char* prints_42 = "  SEQ\n    so.write.string.nl (fs, ts, \"42\")\n    so.exit (fs, ts, sps.success)\n";

} // namespace

TEST_CASE("the exercises have different numbers, in the order of the pages, and each has a task and an output") {
    std::pair<int, int> last{0, 0};
    for (const Exercise& each : exercises()) {
        CAPTURE(each.number);
        const std::size_t dot = each.number.find('.');
        REQUIRE(dot != std::string::npos);
        const std::pair number(std::stoi(each.number), std::stoi(each.number.substr(dot + 1)));
        CHECK(number > last);
        last = number;
        CHECK(each.start.starts_with("-- Exercise " + each.number + ": "));
        CHECK_FALSE(each.title().empty());
        CHECK(each.title().find('\n') == std::string::npos);
        CHECK(each.expected.ends_with('\n'));
        CHECK(exercise_of(each.number).start == each.start);
    }
    CHECK(numbers_of_exercises().size() == exercises().size());
}

TEST_CASE("the title follows the number in the first line; a text without a number has none") {
    CHECK(Exercise{.number = "1.2", .start = "-- Exercise 1.2: An adder\n-- Write: it\n", .expected = ""}.title() ==
          "An adder");
    CHECK(Exercise{.number = "", .start = "", .expected = ""}.title() == "");
    CHECK(Exercise{.number = "1.2", .start = "-- Exercise 1.2: ", .expected = ""}.title() == "");
}

TEST_CASE("an unknown exercise is refused with the first and the last number") {
    for (const char* number : {"", "0.1", "3", "3.2.1", "03.2", "11.1"})
        CHECK_THROWS_AS(exercise_of(number), UserError);
    CHECK_THROWS_WITH_AS(exercise_of("11.1"), "there is no exercise \"11.1\"; the exercises are 1.1 to 10.3",
                         UserError);
}

TEST_CASE("a program that prints the expected output in every order of its processes is a solution") {
    const SolutionVerdict verdict = verdict_on(prints_42, "42\n");
    CHECK(verdict.end == StudentRun::End::completed);
    CHECK(verdict.wrong == "");
    CHECK(verdict.text() == "solved; also with 20 other orders of its processes");
    CHECK(verdict.time > Time{0});
    CHECK(std::string(name_of(verdict.end, verdict.wrong)) == "solved");
}

TEST_CASE("the verdict on another output shows the wrong line") {
    const SolutionVerdict verdict = verdict_on(prints_42, "43\n");
    CHECK(verdict.text() == "not solved: line 1 of the output is wrong\n  expected: \"43\"\n  printed:  \"42\"");
    CHECK(std::string(name_of(verdict.end, verdict.wrong)) == "wrong output");
}

TEST_CASE("a program that is right only in the usual order does not solve the exercise") {
    // Usually both senders have sent when the ALT chooses; in other orders the second may have sent alone.
    const SolutionVerdict verdict = verdict_on("  CHAN OF INT a, b:\n"
                                               "  PAR\n"
                                               "    INT x, y:\n"
                                               "    SEQ\n"
                                               "      ALT\n"
                                               "        a ? x\n"
                                               "          b ? y\n"
                                               "        b ? x\n"
                                               "          a ? y\n"
                                               "      so.write.int (fs, ts, x, 0)\n"
                                               "      so.write.nl (fs, ts)\n"
                                               "      so.exit (fs, ts, sps.success)\n"
                                               "    a ! 1\n"
                                               "    b ! 2\n",
                                               "1\n");
    CHECK(verdict.end == StudentRun::End::completed);
    CHECK(verdict.wrong.starts_with("the program is right in the usual order of its processes, but not in every "
                                    "order\nwith --shuffle "));
    CHECK(verdict.wrong.ends_with("\n  expected: \"1\"\n  printed:  \"2\""));
}

TEST_CASE("a deadlock, a failure, an error and too much output have their own ends") {
    const auto end_of = [](const std::string& process) { return verdict_on(process, "42\n").end; };
    CHECK(end_of("  CHAN OF INT c:\n  c ! 1\n") == StudentRun::End::deadlock);
    CHECK(end_of("  so.exit (fs, ts, sps.failure)\n") == StudentRun::End::failed);
    CHECK(end_of("  INT x:\n  SEQ\n    x := MOSTPOS INT\n    x := x + 1\n") == StudentRun::End::failed);
    CHECK(end_of("  WHILE TRUE\n    so.write.string.nl (fs, ts, \"42\")\n") == StudentRun::End::too_much_output);
}

TEST_CASE("an interrupted check has no verdict") {
    Interruption interruption;
    interruption.request();
    const SolutionVerdict verdict =
        check_solution(student_program(prints_42), {.number = "0.0", .start = "", .expected = "42\n"}, interruption);
    CHECK(verdict.end == StudentRun::End::interrupted);
    CHECK(verdict.wrong == "");
    CHECK(std::string(name_of(verdict.end, verdict.wrong)) == "interrupted");
}
