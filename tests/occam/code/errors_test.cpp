// Executes programs with run_time_errors at run time, and shows what they do in each error mode.

#include "executed.hpp"

#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

using namespace placedpar;
using namespace placedpar::test;

namespace {

constexpr const char* with_values = R"(INT x, zero:
INT16 h:
BYTE b:
[8]INT v:
REAL32 r:
INT64 w:
SEQ
  zero := 0
  w := 0(INT64)
  x := 10
  r := 1.0E+30(REAL32)
  memory[0] := 1
)";

/// An error, and what is said about it.
struct RunTimeError {
    const char *text, *said;
};

constexpr RunTimeError run_time_errors[] = {
    {"x := v[x]", "subscript 10 is outside of an array of 8 elements"},
    {"v[x - 11] := 1", "subscript -1 is outside of an array of 8 elements"},
    {"x := x / zero", "division by zero: 10 / 0"},
    {"x := x \\ zero", "division by zero: 10 \\ 0"},
    {"x := ((MOSTNEG INT) + zero) / (zero - 1)", "overflow: -2147483648 / -1"},
    {"x := (MOSTPOS INT) + (x + zero)", "overflow: 10 + 2147483647"},
    {"x := (x + 2147483637) + 1", "overflow: 2147483647 + 1"},
    {"x := ((zero - 2147483647) - 1) - 5", "overflow: -2147483648 - 5"},
    {"x := (MOSTNEG INT) - (x + zero)", "overflow: -2147483648 - 10"},
    {"x := (x * 1000) * (x * 1000000)", "overflow: 10000 * 10000000"},
    {"x := -((MOSTNEG INT) + zero)", "overflow: -(-2147483648)"},
    {"x := 1 << (x + 23)", "the shift count is 33, but must be 0 to 32"},
    {"b := BYTE (x + 246)", "256 does not fit in BYTE"},
    {"b := BYTE (zero - 1)", "-1 does not fit in BYTE"},
    {"SEQ\n  b := BYTE (x + zero)\n  b := b * b\n  b := b * b", "10000 does not fit in BYTE"},
    {"zero := INT (BOOL x)", "10 does not fit in BOOL"},
    {"h := INT16 (x * 10000)", "100000 does not fit in INT16"},
    {"h := INT16 ((x * 3000) + 10000)", "40000 does not fit in INT16"},
    {"x := INT ROUND r", "the real does not fit in INT"},
    {"x := INT TRUNC (r / (REAL32 ROUND zero))", "the real does not fit in INT, or its computation failed: overflow, "
                                                 "division by zero, an infinity or a NaN"},
    {"w := INT64 ROUND (r / (REAL32 ROUND zero))", "the real does not fit in INT64, or its computation failed: "
                                                   "overflow, division by zero, an infinity or a NaN"},
    {"w := INT64 ROUND r", "the real does not fit in INT64"},
    {"r := r * r", "an operation on reals: overflow, division by zero, an infinity or a NaN"},
    {"[v FROM x - 4 FOR x - 5] := [v FROM 0 FOR 5]",
     "a segment begins at element 6, but can begin only at elements 0 to 3"},
    {"[v FROM 0 FOR x] := [v FROM 0 FOR x]", "a segment of 10 elements does not fit in an array of 8 elements"},
    {"[v FROM x] := [v FROM x]", "a segment begins at element 10 of an array of 8 elements"},
    {"[v FROM x - 7 FOR 3] := [v FROM zero FOR 4 + zero]", "the arrays of this assignment differ in size"},
    {"SEQ i = 0 FOR zero - 1\n  x := i", "the count of this replicator is -1, but must be 0 or more"},
    {"IF\n  x = zero\n    SKIP", "no condition of this IF is true"},
    {"CASE x\n  1\n    SKIP", "this CASE has no option for 10"},
    {"STOP", "STOP"},
    {"CAUSEERROR ()", "CAUSEERROR"},
    {"ASSERT (x = zero)", "the condition of ASSERT is FALSE"},
    {"w := (MOSTPOS INT64) + (INT64 x)", "overflow: 9223372036854775807 + 10"},
    {"w := ((MOSTNEG INT64) + w) - (INT64 x)", "overflow: -9223372036854775808 - 10"},
    {"w := ((MOSTPOS INT64) - w) * (INT64 x)", "overflow: 9223372036854775807 * 10"},
    {"w := (INT64 x) / w", "division by zero: 10 / 0"},
    {"w := (INT64 x) \\ w", "division by zero: 10 \\ 0"},
    {"w := (1(INT64) + w) / w", "division by zero: 1 / 0"},
    {"w := ((MOSTNEG INT64) + w) / (w - 1(INT64))", "overflow: -9223372036854775808 / -1"},
    {"w := -((MOSTNEG INT64) + w)", "overflow: -(-9223372036854775808)"},
    {"ALT\n  ((INT64 x) / w) = w & SKIP\n    SKIP", "division by zero: 10 / 0"},
    {"SEQ\n  w := w + 4294967296(INT64)\n  x := INT w", "4294967296 does not fit in INT"},
    {"SEQ\n  w := w + 4294967296(INT64)\n  b := BYTE w", "4294967296 does not fit in BYTE"},
    {"INT32 n:\nSEQ\n  w := w + 4294967296(INT64)\n  n := INT32 w", "4294967296 does not fit in INT32"},
    {"w := w << (x * x)", "the shift count is 100, but must be 0 to 64"},
};

std::string joined(const std::vector<std::string>& texts) { return fmt::format("{}", fmt::join(texts, ", ")); }

std::string without_place(const std::string& error) { return error.substr(error.find(' ') + 1); }

occam::CodeOptions in_mode(occam::ErrorMode mode) { return {.model = transputer::Model::t800, .mode = mode}; }

} // namespace

TEST_CASE("an error halts the processor in mode halt and in mode universal") {
    for (const RunTimeError& error : run_time_errors)
        for (const occam::ErrorMode mode : {occam::ErrorMode::halt, occam::ErrorMode::universal}) {
            CAPTURE(error.text);
            const Executed done = execute(with_values + indented(error.text, 2) + "  memory[1] := 1\n", in_mode(mode));
            CHECK(done.trouble == "");
            CHECK(done.halted);
            REQUIRE(done.errors.size() == 1);
            CHECK(without_place(done.errors[0]) == error.said);
            CHECK(done.results[0] == 1);
            CHECK(done.results[1] == 0);
        }
}

TEST_CASE("without a floating-point unit, an error of reals names the operation and its place in the program") {
    constexpr RunTimeError errors[] = {
        {"r := r / (REAL32 ROUND zero)", "15:5 REAL32 /: overflow, division by zero, an infinity or a NaN"},
        {"r := (r * r) + r", "15:5 REAL32 *: overflow, an infinity or a NaN"},
        {"r := (r * 3.0E+8(REAL32)) + (r * 3.0E+8(REAL32))", "15:5 REAL32 +: overflow, an infinity or a NaN"},
        {"r := r \\ (REAL32 ROUND zero)", "15:5 REAL32 \\: division by zero, an infinity or a NaN"},
        {"x := INT ROUND r", "15:5 REAL32: the real does not fit in INT"},
        {"w := INT64 TRUNC (REAL64 r)", "15:5 REAL64: the real does not fit in INT64"},
        {"r := REAL32 ROUND ((REAL64 r) * (REAL64 r))", "15:5 REAL64: the real does not fit in REAL32"},
        {"r := SQRT (-r)", "15:5 SQRT: the result is not a finite number"},
        {"IF\n  (MULBY2 (r)) > (r * r)\n    SKIP", "16:7 REAL32 *: overflow, an infinity or a NaN"},
        {"r := SCALEB (r, 1000)", "15:5 SCALEB: the result is not a finite number"},
    };
    for (const RunTimeError& error : errors)
        for (const occam::ErrorMode mode : {occam::ErrorMode::halt, occam::ErrorMode::stop}) {
            CAPTURE(error.text);
            const Executed done = execute(with_values + indented(error.text, 2) + "  memory[1] := 1\n",
                                          {.model = transputer::Model::t414, .mode = mode});
            CHECK(done.trouble == "");
            CHECK(joined(done.errors) == std::string(error.said));
            CHECK(done.results[0] == 1);
            CHECK(done.results[1] == 0);
        }
}

TEST_CASE("an error stops its process in mode stop, and others go on") {
    for (const RunTimeError& error : run_time_errors) {
        CAPTURE(error.text);
        const std::string wrong = with_values + indented(error.text, 2) + "  memory[1] := 1\n";
        const Executed done = execute("SEQ\n  PAR\n" + indented(wrong, 4) + R"(    SEQ
      SEQ i = 0 FOR 1000
        memory[2] := i
      memory[3] := 5 + 6
  memory[4] := 1
)",
                                      in_mode(occam::ErrorMode::stop));
        CHECK(done.trouble == "");
        CHECK_FALSE(done.halted);
        CHECK(done.results[0] == 1);
        CHECK(done.results[1] == 0);
        CHECK(done.results[3] == 11);
        CHECK(done.results[4] == 0);
        REQUIRE(done.errors.size() == 1);
        CHECK(without_place(done.errors[0]) == error.said);
    }
}

TEST_CASE("an error is at the statement, or at the call of a routine for INT64, in each mode") {
    constexpr const char* text = "INT x:\nINT64 w:\nSEQ\n  x := 0\n  w := 1(INT64)\n  w := w / (INT64 x)\n";
    for (const occam::ErrorMode mode : {occam::ErrorMode::halt, occam::ErrorMode::stop, occam::ErrorMode::universal})
        CHECK(joined(execute(text, in_mode(mode)).errors) == "8:5 division by zero: 1 / 0");
}

TEST_CASE("each process that an error has stopped is named, in order of time") {
    const Executed done = execute(R"(PAR i = 0 FOR 3
  INT x:
  SEQ
    x := i
    IF
      i = 1
        SKIP
      TRUE
        STOP
    x := x / (i - 1)
)",
                                  in_mode(occam::ErrorMode::stop));
    CHECK(joined(done.errors) == "11:11 STOP, 12:7 division by zero: 1 / 0, 11:11 STOP");
}

TEST_CASE("a process in an ALT without a true guard is found") {
    const Executed done = execute(R"(CHAN OF INT c:
PAR
  INT x:
  BOOL no:
  SEQ
    no := FALSE
    ALT
      no & c ? x
        SKIP
  INT y:
  TIMER clock:
  BOOL no:
  SEQ
    no := FALSE
    ALT
      no & clock ? AFTER 5
        SKIP
  SKIP
)");
    CHECK(joined(done.waiting) == "15:5 for nothing, 7:5 for nothing");
}

TEST_CASE("what is not compiled is refused by its name and place") {
    CHECK_THROWS_WITH_AS(execute("[10000][10000]INT a:\na[0][0] := 1\n"),
                         doctest::Contains("\"a\" needs 400000000 bytes; a variable can have at most 268435456"),
                         RefusedInput);
    CHECK_THROWS_WITH_AS(execute("PAR i = 0 FOR 1000000\n  [1000]INT a:\n  a[0] := i\n"),
                         doctest::Contains("of vector space, more than a transputer can have"), RefusedInput);
    CHECK_THROWS_WITH_AS(execute("PLACED PAR\n  PROCESSOR 0 T8\n    SKIP\n"), doctest::Contains("PLACED PAR"),
                         std::runtime_error);
}

namespace {

constexpr const char* reader = "PROC reader (CHAN OF INT c)\n  INT x:\n  c ? x\n:\n";

std::string names_of_waiting(const std::string& text, const std::string& declarations = "") {
    std::vector<std::string> names = execute(text, in_mode(occam::ErrorMode::halt), reader + declarations).waiting;
    std::ranges::sort(names);
    return joined(names);
}

} // namespace

TEST_CASE("components of replicated PARs are named by their indices") {
    CHECK(names_of_waiting("[3]CHAN OF INT c:\nPAR i = 7 FOR 3\n  reader (c[i - 7])\n") ==
          "reader[7], reader[8], reader[9]");
    CHECK(names_of_waiting("[2][2]CHAN OF INT c:\nPAR i = 0 FOR 2\n  PAR j = 0 FOR 2\n    reader (c[i][j])\n") ==
          "reader[0][0], reader[0][1], reader[1][0], reader[1][1]");
    CHECK(names_of_waiting("[2]CHAN OF INT c, d:\nPAR i = 0 FOR 2\n  PAR\n    reader (c[i])\n    reader (d[i])\n") ==
          "reader[0] 10:7, reader[0] 11:7, reader[1] 10:7, reader[1] 11:7");
}

TEST_CASE("processes that a procedure starts are named behind its name") {
    constexpr const char* row = "PROC row ([]CHAN OF INT c)\n  PAR i = 0 FOR 2\n    reader (c[i])\n:\n";
    CHECK(names_of_waiting("[2]CHAN OF INT c:\nrow (c)\n", row) == "reader[0], reader[1]");
    CHECK(
        names_of_waiting("[2]CHAN OF INT c:\n[2][2]CHAN OF INT d:\nPAR\n  row (c)\n  PAR i = 0 FOR 2\n    row (d[i])\n",
                         row) ==
        "row 14:5/reader[0], row 14:5/reader[1], row[0] 16:7/reader[0], row[0] 16:7/reader[1], row[1] 16:7/reader[0], "
        "row[1] 16:7/reader[1]");
    CHECK(names_of_waiting("[2]CHAN OF INT c, d:\nSEQ\n  PAR\n    SKIP\n    SKIP\n  row (c)\n", row) ==
          "reader[0], reader[1]");
}

TEST_CASE("the first process has the name of the procedure, and others of the same words have a name together") {
    CHECK(names_of_waiting("CHAN OF INT c:\nreader (c)\n") == "main");
    constexpr const char* after = "CHAN OF INT c, d, e:\nSEQ\n  PAR\n    SKIP\n    SEQ\n      SKIP\n  PAR\n    "
                                  "reader (c)\n    INT x:\n    d ? x\n";
    CHECK(names_of_waiting(after) == "11:7 or reader, 16:7");
}
