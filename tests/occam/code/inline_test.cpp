// Tests that the copy of an INLINE procedure or function does what a call does.

#include "executed.hpp"

#include <doctest/doctest.h>

#include <string>
#include <string_view>

using namespace placedpar;

namespace {

/// Procedures and functions with parameters of all kinds. INLINE stands before PROC and FUNCTION, or nothing does.
constexpr std::string_view declarations = R"(
INT @FUNCTION twice (VAL INT x) IS x + x:
INT @FUNCTION sum (VAL INT x, y)
  INT z:
  VALOF
    z := x + y
    RESULT z - 1
:
BOOL @FUNCTION is.small (VAL BYTE b) IS b < 5 (BYTE):
REAL32 @FUNCTION half (VAL REAL32 r) IS r / 2.0(REAL32):
INT, INT @FUNCTION both (VAL INT x, VAL []INT v) IS x + v[0], x - v[1]:
INT64 @FUNCTION wide (VAL INT64 n) IS n PLUS n:
@PROC add.to (INT x, VAL INT by)
  SEQ
    x := x + by
    x := x + by
:
@PROC fill ([]INT v, VAL []INT from, VAL BYTE b)
  SEQ i = 0 FOR SIZE v
    INT t:
    SEQ
      t := from[i \ (SIZE from)]
      add.to (t, INT b)
      v[i] := t
:
@PROC hand.on (CHAN OF INT in, out, VAL INT more)
  INT x:
  SEQ
    in ? x
    out ! sum (x, more)
:
@PROC nest (INT x)
  PROC inner (VAL INT y)
    x := (x * 10) + y
  :
  SEQ
    inner (1)
    inner (2)
:
)";

constexpr std::string_view body = R"(
[4]CHAN OF INT c:
[5]INT v:
INT a, b, i:
INT64 n:
REAL32 r:
SEQ
  a, b, i := 3, 4, 2
  memory[0] := sum (twice (a), twice (sum (b, twice (7)))) + (a * sum (a, b))
  memory[1] := INT (is.small (4 (BYTE)) AND (NOT is.small (BYTE (a * 2))))
  r := half (half (REAL32 ROUND 20)) + half (3.0 (REAL32))
  memory[2] := INT ROUND (r * 100.0 (REAL32))
  fill (v, [a, b, 7], 10 (BYTE))
  fill ([v FROM 3 FOR 2], [v FROM 0 FOR 2], BYTE a)
  SEQ k = 0 FOR 5
    memory[3 + k] := v[k]
  memory[8], memory[9] := both (a, [v FROM 1 FOR 3])
  add.to (v[i], v[0])
  memory[10] := v[2]
  nest (b)
  nest (v[1])
  memory[11], memory[12] := b, v[1]
  PAR
    c[0] ! 5
    PAR k = 0 FOR 3
      hand.on (c[k], c[k + 1], k * a)
    c[3] ? memory[13]
  n := wide (INT64 a)
  memory[14] := INT wide (n)
)";

std::string text_of(std::string_view text, std::string_view word) {
    std::string result;
    for (const char c : text)
        if (c == '@')
            result += word;
        else
            result += c;
    return result;
}

} // namespace

TEST_CASE("copies of INLINE procedures and functions do what calls do, and take less time") {
    for (const auto mode : {occam::ErrorMode::halt, occam::ErrorMode::stop, occam::ErrorMode::universal}) {
        const occam::CodeOptions options{.model = transputer::Model::t800, .mode = mode};
        const test::Executed called = test::execute(body, options, text_of(declarations, ""));
        const test::Executed copied = test::execute(body, options, text_of(declarations, "INLINE "));
        REQUIRE(called.trouble == "");
        CHECK_FALSE(called.halted);
        CHECK(copied.results == called.results);
        CHECK(called.results[0] == 57);
        CHECK(called.results[13] == 11);
        CHECK(copied.cycles < called.cycles);
    }
}

TEST_CASE("an error in an expression stays one when an INLINE function is copied into it") {
    const std::string text = "INT x, y:\nSEQ\n  x, y := MOSTPOS INT, 1\n  memory[0] := 7\n"
                             "  memory[1] := (x + y) - sum (x, 0 - 5)\n  memory[2] := 1\n";
    for (const auto mode : {occam::ErrorMode::halt, occam::ErrorMode::stop}) {
        const test::Executed copied =
            test::execute(text, {.model = transputer::Model::t800, .mode = mode}, text_of(declarations, "INLINE "));
        CHECK(copied.results[0] == 7);
        CHECK(copied.results[2] == 0);
        CHECK(copied.halted == (mode == occam::ErrorMode::halt));
    }
}
