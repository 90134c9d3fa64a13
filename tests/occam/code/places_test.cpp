// Executes programs with one error each, and checks at which place the error is reported. Also checks the table of
// places of the code.

#include "executed.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

using namespace placedpar;
using namespace placedpar::test;

namespace {

constexpr const char* before_fault = R"(PROTOCOL P
  CASE
    a; INT
:
INT x, y, z:
[8]INT v:
SEQ
  z := 0
  x := 5
)";

/// Each program has one error, at the statement, condition, guard or declaration behind the mark @.
constexpr std::string_view wrong_programs[] = {
    // Declarations
    "@VAL INT k IS 7 / z:\nx := k",
    "@w IS v[x + 5]:\nw := 1",
    "@INITIAL INT k IS 7 / z:\nx := k",
    "@VAL []INT part IS [v FROM x FOR 5]:\ny := part[0]",
    "@[]BYTE bytes RETYPES [v FROM x FOR 5]:\nbytes[0] := 0(BYTE)",
    "VAL INT k IS 1:\n@VAL INT l IS k / z:\nx := l",
    "VAL INT k IS 1:\n@x := k / z",
    // Replicators
    "@SEQ i = 7 / z FOR 3\n  x := i",
    "@SEQ i = 0 FOR z - 2\n  x := i",
    "IF\n  x = 5\n    @SEQ i = 0 FOR z - 2\n      x := i\n  TRUE\n    SKIP",
    "@IF i = 0 FOR 7 / z\n  i = 1\n    SKIP",
    "IF\n  z = 1\n    SKIP\n  @IF i = 7 / z FOR 2\n    i = 1\n      SKIP\n  TRUE\n    SKIP",
    "[3]CHAN OF INT c:\n@ALT i = 0 FOR 7 / z\n  c[i] ? x\n    SKIP",
    "[3]CHAN OF INT c:\nALT\n  @ALT i = 0 FOR 7 / z\n    c[i] ? x\n      SKIP\n  TRUE & SKIP\n    SKIP",
    // Conditions and selectors
    "IF\n  z = 1\n    x := 1\n  @x = (7 / z)\n    SKIP",
    "IF\n  VAL INT k IS 3:\n  @k = (7 / z)\n    SKIP\n  TRUE\n    SKIP",
    "IF\n  @VAL INT k IS 7 / z:\n  k = 3\n    SKIP\n  TRUE\n    SKIP",
    "@IF\n  z = 1\n    x := 1\n  z = 2\n    x := 2",
    "@CASE 7 / z\n  1\n    x := 1\n  ELSE\n    SKIP",
    "@CASE x\n  1\n    x := 1\n  2\n    x := 2",
    "CASE z\n  @VAL INT k IS 7 / z:\n  0\n    x := k",
    "@WHILE x > (7 / z)\n  x := 1",
    "@WHILE (10 / x) < 100\n  SEQ\n    y := x\n    x := x - 1",
    // Guards
    "CHAN OF INT c:\nALT\n  @(7 / z) = 1 & c ? x\n    SKIP\n  TRUE & SKIP\n    SKIP",
    "CHAN OF INT c:\nALT\n  VAL INT k IS 1:\n  @(7 / z) = k & c ? x\n    SKIP\n  TRUE & SKIP\n    SKIP",
    "ALT\n  @VAL INT k IS 7 / z:\n  TRUE & SKIP\n    x := k",
    "TIMER clock:\nALT\n  @clock ? AFTER 7 / z\n    SKIP",
    "INT64 w:\nSEQ\n  w := 0(INT64)\n  ALT\n    @(7(INT64) / w) = 1(INT64) & SKIP\n      SKIP",
    "CHAN OF INT c:\nPAR\n  c ! 1\n  ALT\n    @c ? v[x + 5]\n      x := 1",
    // Communication
    "CHAN OF INT c:\nPAR\n  @c ! 7 / z\n  c ? x",
    "CHAN OF INT c:\nPAR\n  c ! 7\n  @c ? v[x + 5]",
    "CHAN OF P c:\nPAR\n  c ! a; 1\n  c ? CASE\n    @a; v[x + 5]\n      SKIP",
    "CHAN OF P c:\nPAR\n  c ! a; 1\n  @c ? CASE a; v[x + 5]",
    "TIMER clock:\n@clock ? AFTER 7 / z",
    // Functions and values
    "INT FUNCTION f (VAL INT q)\n  INT r:\n  VALOF\n    r := q\n    @RESULT 10 / r\n:\nx := f (z)",
    "INT FUNCTION f (VAL INT q) IS @10 / q:\nx := f (z)",
    "INT, INT FUNCTION f (VAL INT q)\n  INT r:\n  VALOF\n    r := q\n    @RESULT r, 10 / r\n:\nx, y := f (z)",
    "x := (INT r:\n      VALOF\n        r := z\n        @RESULT 10 / r\n     )",
    "@x := 10 / (INT r:\n           VALOF\n             r := z\n             RESULT r\n          )",
    "@v[(INT r:\n    VALOF\n      r := x\n      RESULT r + 5\n   )] := 1",
    "INT, INT FUNCTION f (VAL INT q) IS q, q:\n@y, v[x + 5] := f (z)",
    // Procedures and processes
    "PROC p (VAL INT q)\n  @VAL INT k IS 7 / q:\n  x := k\n:\np (z)",
    "PROC p (VAL INT q)\n  x := q\n:\n@p (7 / z)",
    "PROC p (VAL INT q)\n  x := q\n:\nSEQ\n  p (z)\n  @y := 7 / z",
    "PAR\n  x := 1\n  @VAL INT k IS 7 / z:\n  y := k",
    "SEQ\n  PAR\n    x := 1\n    y := 1\n  @x, y := 7 / z, 1",
};

/// In mode stop, these errors do not stop the process, because no `stoperr` follows them.
constexpr std::string_view wrong_programs_in_mode_halt[] = {
    "@SEQ i = x FOR 3 STEP 7 / z\n  y := i",
    "@PAR i = 7 / z FOR 2\n  INT own:\n  own := i",
};

/// Returns what `text` becomes in the program that execute() makes of it, and the place of the mark @ there.
std::pair<std::string, std::string> marked(std::string_view text) {
    std::string program = before_fault + indented(text, 2) + (text.ends_with('\n') ? "" : "\n");
    const std::size_t mark = program.find('@');
    program.erase(mark, 1);
    constexpr std::size_t lines_above = 2, blanks = 2; // the protocol and the PROC of execute()
    const auto line = std::count(program.begin(), program.begin() + static_cast<std::ptrdiff_t>(mark), '\n');
    const std::size_t column = mark - (program.rfind('\n', mark - 1) + 1);
    return {program, fmt::format("{}:{}", static_cast<std::size_t>(line) + 1 + lines_above, column + 1 + blanks)};
}

/// Checks that the only error of a program is reported at its mark.
void check_place(std::string_view text, occam::ErrorMode mode) {
    CAPTURE(text);
    const auto [program, place] = marked(text);
    const Executed done = execute(program, {.model = transputer::Model::t800, .mode = mode});
    CHECK(done.trouble == "");
    REQUIRE(done.errors.size() == 1);
    CHECK(done.errors[0].substr(0, done.errors[0].find(' ')) == place);
}

/// Returns the line of each row of the table of places, in the order of the code; 0 for code without a place.
std::string lines_of(const std::string& text) {
    std::vector<std::uint32_t> lines;
    for (const occam::CodeLine& each : compiled_program(text, {.model = transputer::Model::t800}).code.lines)
        lines.push_back(each.place.line);
    return fmt::format("{}", fmt::join(lines, " "));
}

} // namespace

TEST_CASE("an error is reported at the statement, declaration, guard or result that has it") {
    for (const std::string_view each : wrong_programs)
        for (const occam::ErrorMode mode : {occam::ErrorMode::halt, occam::ErrorMode::stop})
            check_place(each, mode);
    for (const std::string_view each : wrong_programs_in_mode_halt)
        check_place(each, occam::ErrorMode::halt);
}

TEST_CASE("code after a nested statement belongs to the statement around it, and the start to no place") {
    constexpr const char* repeated = R"(PROC main ()
  INT x:
  SEQ
    SEQ i = 0 FOR 3
      x := i
    WHILE x > 0
      x := x - 1
:
)";
    CHECK(lines_of(repeated) == "1 4 5 4 6 7 6 1 0");
    constexpr const char* chosen = R"(PROC main ()
  INT x:
  SEQ
    x := 1
    IF
      x = 1
        x := 2
      x = 2
        x := 3
    CASE x
      1
        x := 4
      2
        x := 5
:
)";
    CHECK(lines_of(chosen) == "1 4 6 7 6 8 9 8 5 10 12 10 14 10 1 0");
}

TEST_CASE("the first and the last instructions of a procedure have the place of its name") {
    constexpr const char* nested = R"(PROC main ()
  PROC p (VAL INT z)
    INT x:
    x := z
  :
  PAR
    p (1)
    p (2)
:
)";
    CHECK(lines_of(nested) == "1 6 7 6 8 6 1 2 4 2 0");
}
