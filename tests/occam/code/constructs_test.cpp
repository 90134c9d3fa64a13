// Executes each construct of occam on the emulated transputer, with known answers.

#include "executed.hpp"

#include <doctest/doctest.h>

#include <array>
#include <string>
#include <vector>

using namespace placedpar;
using namespace placedpar::test;

namespace {

constexpr std::array error_modes = {occam::ErrorMode::halt, occam::ErrorMode::stop, occam::ErrorMode::universal};

/// Executes a program in all error_modes, with and without checks, and with arrays in both places.
void expect_words(const std::vector<std::int32_t>& expected, std::string_view body,
                  std::string_view declarations = "") {
    for (const occam::ErrorMode mode : error_modes)
        for (const bool checks : {true, false})
            for (const bool vector_space : {true, false}) {
                CAPTURE(body);
                CAPTURE(static_cast<int>(mode));
                CAPTURE(checks);
                CAPTURE(vector_space);
                Executed done = execute(body,
                                        {.model = transputer::Model::t800,
                                         .mode = mode,
                                         .range_checks = checks,
                                         .run_time_checks = checks,
                                         .vector_space = vector_space},
                                        declarations);
                CHECK(done.trouble == "");
                CHECK_FALSE(done.halted);
                done.results.resize(expected.size());
                CHECK(done.results == expected);
            }
}

} // namespace

TEST_CASE("assignments, also of several values and of arrays") {
    expect_words({2, 1, 7, 30, 20, 10}, R"(INT x, y:
[3]INT a, b:
SEQ
  x, y := 1, 2
  x, y := y, x
  memory[0] := x
  memory[1] := y
  a := [10, 20, 30]
  b := a
  a[0] := 7
  memory[2] := a[0]
  b[0], b[2] := b[2], b[0]
  [memory FROM 3 FOR 3] := b
)");
}

TEST_CASE("IF, CASE and WHILE") {
    expect_words({3, 20, 20, 99, 1, 4, 2, -2}, R"(INT x:
SEQ
  x := 3
  IF
    x < 3
      memory[0] := 1
    IF i = 0 FOR 5
      i = x
        memory[0] := i
    TRUE
      memory[0] := 2
  SEQ i = 0 FOR 3
    CASE i + 1
      1, 2
        memory[1 + i] := 20
      ELSE
        memory[1 + i] := 99
  SEQ i = 0 FOR 3
    CASE i * 7
      0
        memory[4 + i] := 1
      7
        memory[4 + i] := 4
      14
        memory[4 + i] := 2
  x := 10
  WHILE x > 0
    x := x - 3
  memory[7] := x
)");
    std::string options, expected_text;
    std::vector<std::int32_t> expected;
    for (int i = 0; i < 20; ++i) {
        options += "    " + std::to_string(i + 5) + "\n      memory[i] := " + std::to_string(i * i) + "\n";
        expected.push_back(i < 5 ? -1 : (i - 5) * (i - 5));
    }
    expect_words(expected, "SEQ i = 0 FOR 20\n  CASE i\n" + options + "    ELSE\n      memory[i] := -1\n");
}

TEST_CASE("a counted array may have a count of any integer type") {
    expect_words({3, 3, 3, 3, 0}, R"(PROC pass (VAL INT n, INT result)
  CHAN OF INT16::[]BYTE a:
  CHAN OF INT64::[]BYTE b:
  CHAN OF BYTE::[]INT c:
  [4]BYTE s:
  [4]INT v:
  INT16 i:
  INT64 l:
  BYTE y:
  PAR
    SEQ
      a ! (INT16 n)::"abcd"
      b ! (INT64 n)::"abcd"
      c ! (BYTE n)::[1, 2, 3, 4]
    SEQ
      l := -1(INT64)
      a ? i::s
      b ? l::s
      c ? y::v
      result := ((INT i) /\ (INT l)) /\ (INT y)
:
SEQ
  SEQ i = 0 FOR 4
    pass (3, memory[i])
  pass (0, memory[4])
)");
}

TEST_CASE("CASE of an INT64 compares both halves") {
    expect_words({1, 2, 3, 4, 4},
                 R"(VAL [5]INT64 given IS [7(INT64), 4294967303(INT64), (-7(INT64)), 4294967289(INT64), 0(INT64)]:
SEQ i = 0 FOR 5
  CASE given[i]
    7(INT64)
      memory[i] := 1
    4294967303(INT64), 8589934599(INT64)
      memory[i] := 2
    (-7(INT64))
      memory[i] := 3
    ELSE
      memory[i] := 4
)");
}

TEST_CASE("a call among the arguments of a call stores nothing over the others") {
    expect_words({6}, R"([8]INT v:
INT FUNCTION masked (VAL INT a, b, c, d) IS (a /\ b) + (c + d):
INT64 FUNCTION sum (VAL INT64 a, VAL INT b) IS a + (INT64 b):
INT64 s, one:
SEQ
  one := 1(INT64)
  SEQ i = 0 FOR 8
    v[i] := i
  s := sum (one, v[masked (v[4], 7, 0, v[1])])
  memory[0] := INT s
)");
}

TEST_CASE("replicators with counts that are not constant, and none") {
    expect_words({0, 1, 3, 6, 4}, R"(INT n, s:
SEQ
  n := 0
  s := 0
  SEQ i = 5 FOR n
    s := s + 100
  memory[0] := s
  n := 3
  SEQ i = 1 FOR n
    SEQ
      s := s + i
      memory[i] := s
  memory[4] := n + 1
)");
}

TEST_CASE("procedures and functions: references, values, open arrays, variables around them, results") {
    expect_words({12, 5, 30, 3, 2, 1234567, 81, 108}, R"(INT x, y:
PROC add (INT a, VAL INT b)
  a := a + b
:
PROC outer (VAL INT k)
  INT local:
  PROC inner ()
    x := x + (local * k)
  :
  SEQ
    local := 2
    inner ()
:
INT FUNCTION total (VAL []INT a)
  INT t:
  VALOF
    SEQ
      t := 0
      SEQ i = 0 FOR SIZE a
        t := t + a[i]
    RESULT t
:
INT, INT FUNCTION divide (VAL INT a, b) IS a / b, a \ b:
PROC seven (VAL INT a, b, c, d, e, f, INT g)
  g := (((((((((((a * 10) + b) * 10) + c) * 10) + d) * 10) + e) * 10) + f) * 10) + 7
:
INT FUNCTION square (VAL INT a) IS a * a:
[4]INT v:
SEQ
  x := 2
  add (x, 4)
  outer (3)
  memory[0] := x
  y := 5
  memory[1] := y
  v := [3, 10, 20, 4]
  memory[2] := total ([v FROM 1 FOR 2])
  x, y := divide (17, 5)
  memory[3] := x
  memory[4] := y
  seven (1, 2, 3, 4, 5, 6, memory[5])
  memory[6] := square (square (x))
  memory[7] := (square (x) * square (2)) + (square (6) + square (square (x) - 3))
)");
}

TEST_CASE("abbreviations, RETYPES, slices and tables") {
    expect_words({9, 55, 2, 7, 67305985, 1065353216, 3, 14}, R"([2][4]INT m:
INT i:
SEQ
  SEQ a = 0 FOR 2
    SEQ b = 0 FOR 4
      m[a][b] := (a * 10) + b
  i := 1
  row IS m[i]:
  e IS row[2]:
  e := 9
  memory[0] := m[1][2]
  s IS [m[i] FROM i FOR 2]:
  SEQ
    s[0] := 55
    memory[2] := SIZE s
  memory[1] := m[1][1]
  VAL []INT table IS [5, 6, 7]:
  memory[3] := table[i + 1]
  [4]BYTE b:
  SEQ
    b := [1(BYTE), 2(BYTE), 3(BYTE), 4(BYTE)]
    VAL INT w RETYPES b:
    memory[4] := w
  VAL REAL32 r IS 1.0(REAL32):
  VAL INT w RETYPES r:
  memory[5] := w
  VAL INT k IS i + 2:
  SEQ
    memory[6] := k
    memory[7] := (INT t:
                  VALOF
                    t := k * 4
                    RESULT t + 2
                 )
)");
}

TEST_CASE("PAR: components, replicated, nested, with arrays of their own") {
    expect_words({10, 20, 0, 1, 4, 9, 16, 33}, R"(INT x, y:
[5]INT squares:
SEQ
  PAR
    [8]INT own:
    SEQ
      SEQ i = 0 FOR 8
        own[i] := 1
      x := own[7] + 9
    [8]INT own:
    SEQ
      SEQ i = 0 FOR 8
        own[i] := 2
      y := own[7] * 10
  memory[0] := x
  memory[1] := y
  PAR i = 0 FOR 5
    [20]INT own:
    SEQ
      SEQ k = 0 FOR 20
        own[k] := i
      squares[i] := own[19] * own[0]
  SEQ i = 0 FOR 5
    memory[2 + i] := squares[i]
  CHAN OF INT c, d:
  PAR
    PAR
      c ! 11
      INT t:
      SEQ
        c ? t
        d ! t + 22
    d ? memory[7]
)");
}

TEST_CASE("PRI PAR goes on at low priority") {
    expect_words({5, 1}, R"(CHAN OF INT c:
TIMER t:
INT x, before, after:
SEQ
  PRI PAR
    c ! 5
    SEQ
      c ? x
      SKIP
  memory[0] := x
  t ? before
  SEQ i = 0 FOR 100
    x := i
  t ? after
  IF
    (after MINUS before) < 5
      memory[1] := 1
    TRUE
      memory[1] := after MINUS before
)");
}

TEST_CASE("protocols: sequences, counted arrays, variants") {
    expect_words({42, 99, 3, 7, 9, 5, 0, 17}, R"(CHAN OF P pair:
CHAN OF BYTE::[]INT counted:
CHAN OF V v:
CHAN OF [2]INT16 shorts:
PAR
  SEQ
    pair ! 42; 'c'
    counted ! 3(BYTE)::[7, 8, 9, 10]
    v ! number; 5
    v ! nothing
    shorts ! [10(INT16), 7(INT16)]
  INT n:
  BYTE b, count:
  [6]INT a:
  [2]INT16 s:
  SEQ
    pair ? n; b
    memory[0] := n
    memory[1] := INT b
    counted ? count::a
    memory[2] := INT count
    memory[3] := a[0]
    memory[4] := a[2]
    SEQ i = 0 FOR 2
      v ? CASE
        number; memory[5]
          SKIP
        nothing
          memory[6] := 0
    shorts ? s
    memory[7] := (INT s[0]) + (INT s[1])
)",
                 "PROTOCOL P IS INT; BYTE:\nPROTOCOL V\n  CASE\n    number; INT\n    nothing\n:\n");
}

TEST_CASE("ALT: priority, guards, replicated, nested, with time-outs and SKIP") {
    expect_words({6, 1, 2, 210, 1, 1}, R"([3]CHAN OF INT c:
CHAN OF INT never:
TIMER t:
INT x, total, now, later:
SEQ
  total := 0
  PAR
    PAR i = 0 FOR 3
      c[i] ! i + 1
    SEQ k = 0 FOR 3
      INT y:
      ALT i = 0 FOR 3
        c[i] ? y
          total := total + y
  memory[0] := total
  PRI ALT
    FALSE & SKIP
      memory[1] := 0
    TRUE & SKIP
      memory[1] := 1
  PAR
    c[0] ! 2
    SEQ
      ALT
        FALSE & never ? x
          memory[2] := 0
        ALT
          never ? x
            memory[2] := 1
          c[0] ? x
            memory[2] := x
  total := 0
  PAR
    PAR i = 0 FOR 3
      SEQ j = 1 FOR 2
        c[i] ! j * 10
    SEQ k = 0 FOR 6
      INT y:
      PRI ALT
        ALT i = 1 FOR 2
          VAL INT twice IS i + i:
          c[i] ? y
            total := total + (y * twice)
        c[0] ? y
          total := total + y
  memory[3] := total
  t ? now
  ALT
    never ? x
      memory[4] := 0
    t ? AFTER now PLUS 20
      memory[4] := 1
  t ? later
  IF
    ((later MINUS now) > 20) AND ((later MINUS now) < 23)
      memory[5] := 1
    TRUE
      memory[5] := later MINUS now
)");
}

TEST_CASE("predefined functions") {
    expect_words({1, 0, 1, 31, -13, 0x34567812, 9, 12}, R"(INT a, b, c:
SEQ
  a, b := LONGSUM (#FFFFFFFF, 1, 0)
  memory[0] := a
  memory[1] := b
  a, b := LONGPROD (#10000, #10000, 0)
  memory[2] := a
  a, b, c := NORMALISE (1, 0)
  memory[3] := a
  memory[4] := ASHIFTRIGHT (-100, 3)
  memory[5] := ROTATELEFT (#12345678, 8)
  memory[6] := BITCOUNT (#FF, 1)
  memory[7] := LONGADD (5, 6, 1)
)");
}

TEST_CASE("a replicated PAR of 1000 processes in a ring") {
    expect_words({1000}, R"([1001]CHAN OF INT c:
PAR
  PAR i = 0 FOR 1000
    INT x:
    SEQ
      c[i] ? x
      c[i + 1] ! x + 1
  SEQ
    c[0] ! 0
    c[1000] ? memory[0]
)");
}

TEST_CASE("components of a replicated PAR call procedures with arrays of their own") {
    expect_words({0, 40, 80, 120}, R"(PROC sum (VAL INT n, INT total)
  [40]INT own:
  SEQ
    SEQ i = 0 FOR 40
      own[i] := n
    total := 0
    SEQ i = 0 FOR 40
      total := total + own[i]
:
[4]INT totals:
SEQ
  PAR i = 0 FOR 4
    sum (i, totals[i])
  [memory FROM 0 FOR 4] := totals
)");
}

TEST_CASE("reals are copied and passed without a floating-point unit") {
    const Executed done = execute(R"(REAL64 FUNCTION same (VAL REAL64 x) IS x:
PROC both (VAL REAL32 r, VAL REAL64 d, [2]REAL64 a)
  VAL INT w RETYPES r:
  SEQ
    memory[0] := w
    a[1] := same (d)
:
REAL32 r:
REAL64 d:
[2]REAL64 a:
SEQ
  r, d := 1.0(REAL32), 2.0(REAL64)
  both (r, d, a)
  VAL [4]INT w RETYPES a:
  memory[1] := w[3]
)",
                                  {.model = transputer::Model::t414});
    CHECK(done.trouble == "");
    CHECK(done.results[0] == 0x3f800000);
    CHECK(done.results[1] == 0x40000000);
}
