// Executes programs with run_time_errors at run time, and shows what they do in each error mode.

#include "executed.hpp"

#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <array>
#include <string>

using namespace placedpar;
using namespace placedpar::test;

namespace {

constexpr const char* with_values = R"(INT x, zero:
INT16 h:
BYTE b:
[8]INT v:
REAL32 r:
SEQ
  zero := 0
  x := 10
  r := 1.0E+30(REAL32)
  memory[0] := 1
)";

constexpr std::array run_time_errors = {
    "x := v[x]",
    "v[x - 11] := 1",
    "x := x / zero",
    "x := x \\ zero",
    "x := (MOSTPOS INT) + (x + zero)",
    "x := (MOSTNEG INT) - (x + zero)",
    "x := (x * 1000) * (x * 1000000)",
    "x := -((MOSTNEG INT) + zero)",
    "x := 1 << (x + 23)",
    "b := BYTE (x + 246)",
    "h := INT16 (x * 10000)",
    "h := INT16 ((x * 3000) + 10000)",
    "x := INT ROUND r",
    "x := INT TRUNC (r / (REAL32 ROUND zero))",
    "r := r * r",
    "[v FROM x - 4 FOR x - 5] := [v FROM 0 FOR 5]",
    "[v FROM x - 7 FOR 3] := [v FROM zero FOR 4 + zero]",
    "SEQ i = 0 FOR zero - 1\n  x := i",
    "IF\n  x = zero\n    SKIP",
    "CASE x\n  1\n    SKIP",
    "STOP",
    "CAUSEERROR ()",
    "ASSERT (x = zero)",
};

occam::CodeOptions in_mode(occam::ErrorMode mode) { return {.model = transputer::Model::t800, .mode = mode}; }

} // namespace

TEST_CASE("an error halts the processor in mode halt and in mode universal") {
    for (const char* error : run_time_errors)
        for (const occam::ErrorMode mode : {occam::ErrorMode::halt, occam::ErrorMode::universal}) {
            CAPTURE(error);
            const Executed done = execute(with_values + indented(error, 2) + "  memory[1] := 1\n", in_mode(mode));
            CHECK(done.trouble == "");
            CHECK(done.halted);
            CHECK(done.results[0] == 1);
            CHECK(done.results[1] == 0);
        }
}

TEST_CASE("an error stops its process in mode stop, and others go on") {
    for (const char* error : run_time_errors) {
        CAPTURE(error);
        const std::string wrong = with_values + indented(error, 2) + "  memory[1] := 1\n";
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
    }
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
