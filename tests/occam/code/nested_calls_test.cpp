// Executes functions that are arguments of themselves, and segments of constant length of open arrays.

#include "executed.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace placedpar;
using namespace placedpar::test;

TEST_CASE("INLINE functions whose arguments call the same function") {
    constexpr const char* functions = R"(INT INLINE FUNCTION added (VAL INT a, b) IS a + b:
INT INLINE FUNCTION least (VAL INT a, b)
  INT result:
  VALOF
    IF
      a < b
        result := a
      TRUE
        result := b
    RESULT result
:
)";
    const Executed done = execute(R"(INT k:
SEQ
  k := 2
  memory[0] := added (added (1, k), 10)
  memory[1] := added (added (k, k), added (10, k))
  memory[2] := least (least (7, k), 9)
)",
                                  {.model = transputer::Model::t800}, functions);
    CHECK(done.results[0] == 13);
    CHECK(done.results[1] == 16);
    CHECK(done.results[2] == 2);
}

TEST_CASE("a segment of constant length that is longer than its array halts the processor") {
    constexpr const char* procedures = R"(PROC write ([]INT v, VAL INT i)
  [v FROM i FOR 6] := [1, 2, 3, 4, 5, 6]
:
)";
    for (const int size : {4, 5, 6}) {
        const Executed done = execute("[" + std::to_string(size) + "]INT v:\nSEQ\n  write (v, 0)\n  memory[0] := 1\n",
                                      {.model = transputer::Model::t800}, procedures);
        CHECK(done.halted == (size < 6));
        if (done.halted)
            CHECK(done.errors.front().find("a segment of 6 elements does not fit in an array of " +
                                           std::to_string(size)) != std::string::npos);
    }
}
