#include "explore/exercise/student_run.hpp"

#include <doctest/doctest.h>

#include <string>

namespace placedpar {

namespace {

std::string wrong(const std::string& printed, const std::string& expected) {
    return what_is_wrong({.output = printed}, expected);
}

} // namespace

TEST_CASE("an output is compared line by line, without blanks at the ends") {
    CHECK(wrong("1\n2\n", "1\n2\n") == "");
    CHECK(wrong("1 \r\n2\n\n \n", "1\n2\n") == "");
    CHECK(wrong("1\n2", "1\n2\n") == "");
    CHECK(wrong("", "") == "");
    CHECK(wrong("1\n\n2\n", "1\n2\n") == "line 2 of the output is wrong\n  expected: \"2\"\n  printed:  \"\"");
    CHECK(wrong(" 1\n2\n", "1\n2\n") == "line 1 of the output is wrong\n  expected: \"1\"\n  printed:  \" 1\"");
    CHECK(wrong("1\n", "1\n2\n3\n") == "line 2 of the output is missing\n  expected: \"2\"");
    CHECK(wrong("", "1\n") == "line 1 of the output is missing\n  expected: \"1\"");
    CHECK(wrong("1\n2\n", "1\n") == "the output has more than 1 line\n  printed in line 2: \"2\"");
}

TEST_CASE("another end than success is wrong whatever was printed") {
    const std::string expected = "1\n";
    CHECK(what_is_wrong({.end = StudentRun::End::failed, .output = "1\n", .state = "exited with failure"}, expected) ==
          "the program exited with failure, after 1 line of output");
    CHECK(what_is_wrong({.end = StudentRun::End::deadlock, .output = "", .time = std::chrono::milliseconds(2)},
                        expected) ==
          "the program is in a deadlock at 2.000000 ms, after 0 lines of output: its processes wait for each other, or "
          "for a process that has ended");
    CHECK(what_is_wrong({.end = StudentRun::End::too_long, .output = "1\n2\n"}, expected) ==
          "the program has not ended after 10 s of simulated time, after 2 lines of output");
    CHECK(what_is_wrong({.end = StudentRun::End::too_much_output, .output = "1\n"}, expected) ==
          "the program prints more than 65536 bytes, but the expected output has 2");
}

} // namespace placedpar
