// Executes ALTs whose guards call functions. A call writes over words below the workspace, where an alternation has its
// state from alt to altend; so does a routine that multiplies INT64s, or that computes reals without a floating-point
// unit.

#include "executed.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace placedpar;
using namespace placedpar::test;

namespace {

constexpr const char* functions_of_guards = R"(BOOL FUNCTION same (VAL BOOL a, b)
  BOOL result:
  VALOF
    result := a
    RESULT result = b
:
INT FUNCTION sum (VAL INT a, b, c, d, e)
  INT result:
  VALOF
    SEQ
      result := 0
      SEQ i = 0 FOR 3
        result := result + 1
    RESULT ((((result + a) + b) + c) + d) + e
:
)";

void expect_with_functions(const std::vector<std::int32_t>& expected, const std::string& body) {
    for (const auto model : {transputer::Model::t800, transputer::Model::t414})
        for (const auto mode : {occam::ErrorMode::halt, occam::ErrorMode::stop, occam::ErrorMode::universal}) {
            Executed done = execute(body, {.model = model, .mode = mode}, functions_of_guards);
            CAPTURE(body);
            CAPTURE(done.trouble);
            CHECK_FALSE(done.halted);
            done.results.resize(expected.size());
            CHECK(done.results == expected);
        }
}

} // namespace

TEST_CASE("functions in guards leave the state of the ALT as it is") {
    expect_with_functions({66, 2, 3, 30}, R"(CHAN OF INT c, never:
TIMER t:
INT x, now:
BOOL yes:
INT64 large:
REAL32 r:
SEQ
  yes := TRUE
  large := 3 (INT64)
  r := 1.5 (REAL32)
  ALT
    same (FALSE, yes) & never ? x
      memory[0] := 33
    same (yes, yes) & SKIP
      memory[0] := 66
  PAR
    c ! 2
    ALT
      same (yes, FALSE) & SKIP
        memory[1] := 1
      (sum (1, 2, 3, 4, 5) = 18) & c ? memory[1]
        SKIP
  t ? now
  ALT
    (large * large) = (10 (INT64)) & SKIP
      memory[2] := 1
    (r * r) > 2.5 (REAL32) & SKIP
      memory[2] := 2
    t ? AFTER now PLUS sum (0, 0, 0, 0, 1)
      memory[2] := 3
  memory[3] := 0
  PAR
    SEQ i = 0 FOR 5
      SEQ
        t ? now
        t ? AFTER now PLUS 2
        c ! i * 3
    SEQ k = 0 FOR 5
      ALT i = 0 FOR 4
        VAL wanted IS sum (i, 0, 0, 0, 0):
        (wanted = 5) & c ? x
          memory[3] := memory[3] + x
)");
}

TEST_CASE("a process behind a nested ALT sees the variables that were declared before the ALT") {
    expect_with_functions({7, 3, 10}, R"(CHAN OF INT c, never:
INT x:
PAR
  c ! 7
  ALT
    never ? x
      SKIP
    VAL three IS sum (0, 0, 0, 0, 0):
    INT y, z:
    ALT i = 0 FOR 2
      (i = 1) & c ? y
        SEQ
          SEQ k = 0 FOR 5
            z := k
          memory[0] := y
          memory[1] := three
          memory[2] := (three + y) * i
)");
}
