// Tests the cycles of lines of occam. The expected numbers are sums of the cycles in INMOS's data book of the T800.

#include "explore/check/line_cycles.hpp"

#include "explore/occam_check.hpp"
#include "occam/language/tree.hpp"
#include "runtime/transputer/instruction.hpp"
#include "tests/scratch.hpp"

#include <doctest/doctest.h>

#include <map>
#include <memory>
#include <string>

using namespace placedpar;
using transputer::Model;

namespace {

std::map<std::size_t, LineCycles> cycles_in(const std::string& text, Model model = Model::t800) {
    const Scratch folder; // a second program includes the file
    const std::string path = folder.write("program.occ", text).string();
    const OccamCheck program = check_occam_source(std::make_shared<const SourceFile>(path, text), {},
                                                  {.alias_checks = false, .usage_checks = false});
    REQUIRE_FALSE(program.failed);
    return cycles_of_lines(*program.program, {}, model);
}

/// Returns the text for line 4 of a procedure whose lines 1 to 3 declare x, y and r.
std::string cycles_of_line(const std::string& process, Model model = Model::t800) {
    const auto lines =
        cycles_in("PROC p (REAL32 r, CHAN OF INT c)\n  INT x, y:\n  SEQ\n    " + process + "\n    SKIP\n:\n", model);
    REQUIRE(lines.contains(4));
    return text_of_cycles(lines.at(4), model);
}

} // namespace

TEST_CASE("a line's cycles are the sum of its instructions' cycles") {
    CHECK(cycles_of_line("x := 1") == "2 instructions, 2 cycles on a T800\n");       // ldc 1; stl
    CHECK(cycles_of_line("x := y") == "2 instructions, 3 cycles on a T800\n");       // ldl 2; stl
    CHECK(cycles_of_line("x := y + 3") == "3 instructions, 4 cycles on a T800\n");   // ldl; adc; stl
    CHECK(cycles_of_line("x := x + y") == "4 instructions, 6 cycles on a T800\n");   // ldl; ldl; add; stl
    CHECK(cycles_of_line("x := x / y") == "4 instructions, 45 cycles on a T800\n");  // div 39, with its prefix 40
    CHECK(cycles_of_line("x := x \\ y") == "4 instructions, 43 cycles on a T800\n"); // rem 37, with its prefix 38
    CHECK(cycles_of_line("x := 100") == "2 instructions, 3 cycles on a T800\n");     // ldc with one prefix
}

TEST_CASE("a range is stated if the cycles depend on the operands, and a bound if they depend on a message") {
    CHECK(text_of_cycles({.instructions = 3, .least = 7, .most = 9}, Model::t800) ==
          "3 instructions, 7 to 9 cycles on a T800\n");
    CHECK(text_of_cycles({.instructions = 1, .least = 7, .most = 7}, Model::t414) ==
          "1 instruction, 7 cycles on a T414\n");
    CHECK(text_of_cycles({.instructions = 1, .least = 7, .most = 9, .is_open = true}, Model::t800) ==
          "1 instruction, 7 or more cycles on a T800\n");
    const auto lines = cycles_in("PROC p (CHAN OF [8]BYTE c)\n  [8]BYTE a:\n  SEQ\n    c ! a\n    SKIP\n:\n");
    REQUIRE(lines.contains(4));
    CHECK(lines.at(4).is_open);
}

TEST_CASE("lines without instructions have no entry; unused procedures have theirs") {
    const auto lines = cycles_in("-- a comment\nPROC unused ()\n  INT x:\n  x := 1\n:\nPROC main ()\n  SKIP\n:\n");
    CHECK_FALSE(lines.contains(1));
    CHECK_FALSE(lines.contains(3));
    REQUIRE(lines.contains(4));
    CHECK(lines.at(4).instructions >= 2);
}

TEST_CASE("procedures with parameters of every form are compiled") {
    const auto lines =
        cycles_in("PROTOCOL PAIR IS INT; BYTE:\n"
                  "PROC p (VAL INT a, [] BYTE b, [3][]INT n, CHAN OF PAIR c, [] CHAN OF INT d, TIMER t)\n"
                  "  SEQ\n"
                  "    b[0] := 'x'\n"
                  "    c ! a; b[0]\n"
                  ":\n");
    CHECK(lines.contains(4));
    CHECK(lines.contains(5));
}

TEST_CASE("a file without procedures has no cycles") { CHECK(cycles_in("VAL n IS 3:\n").empty()); }
