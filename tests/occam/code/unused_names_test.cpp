// Executes programs in which the index of a replicated PAR, or a name with an error in its value, is never used.

#include "executed.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>

using namespace placedpar;
using namespace placedpar::test;

namespace {

constexpr const char* worker = R"(PROC worker (CHAN OF INT in, out)
  INT x:
  SEQ
    in ? x
    out ! x * 2
:
)";

/// A component of a replicated PAR that leaves the memory of others alone.
struct Component {
    const char* text;
    bool uses_index;
};

constexpr Component replicated_components[] = {
    {"SKIP", false},
    {"INT x:\nSEQ\n  x := 7\n  ASSERT (x = 7)", false},
    {"[20]INT x:\nSEQ\n  SEQ j = 0 FOR 20\n    x[j] := j\n  ASSERT (x[19] = 19)", false},
    {"[20]INT x:\nSEQ\n  x[19] := k\n  ASSERT (x[19] = k)", true},
    {"CHAN OF INT c, d:\nINT y:\nPAR\n  worker (c, d)\n  SEQ\n    c ! 21\n    d ? y\n    ASSERT (y = 42)", false},
    {"PAR l = 0 FOR 3\n  INT x:\n  SEQ\n    x := 7\n    ASSERT (x = 7)", false},
    {"PAR l = 0 FOR 3\n  INT x:\n  SEQ\n    x := l\n    ASSERT (x = l)", false},
    {"PAR l = 0 FOR 3\n  INT x:\n  SEQ\n    x := k\n    ASSERT (x = k)", true},
};

/// Returns a process in which the component is executed `count` times in parallel, between variables that must keep
/// their values.
std::string among_variables(const Component& component, int count) {
    return fmt::format(
        "INT a, b, e:\nSEQ\n  a, b, e := 1, 2, 3\n  PAR\n    PAR k = 0 FOR {}\n{}    INT f, g:\n    SEQ\n"
        "      f, g := 4, 5\n      SEQ j = 0 FOR 100\n        SKIP\n      memory[0] := f + g\n"
        "  memory[1] := (a + b) + e\n",
        count, indented(std::string(component.text) + "\n", 6));
}

constexpr const char* timers_and_values = R"(INT x, zero:
[8]INT v:
[4]TIMER clock:
SEQ
  zero := 0
  x := 10
  memory[0] := 1
)";

struct UnusedError {
    const char *text, *said;
};

constexpr UnusedError unused_errors[] = {
    {"INT y IS v[x]:\nSKIP", "subscript 10 is outside of an array of 8 elements"},
    {"VAL INT y IS v[x]:\nSKIP", "subscript 10 is outside of an array of 8 elements"},
    {"VAL INT y IS x / zero:\nSKIP", "division by zero: 10 / 0"},
    {"[]INT y IS [v FROM x]:\nSKIP", "a segment begins at element 10 of an array of 8 elements"},
    {"[4]BYTE y RETYPES v[x]:\nSKIP", "subscript 10 is outside of an array of 8 elements"},
    {"SEQ i = 0 FOR 2 STEP v[x]\n  SKIP", "subscript 10 is outside of an array of 8 elements"},
    {"PAR i = v[x] FOR 2\n  SKIP", "subscript 10 is outside of an array of 8 elements"},
    {"clock[x] ? zero", "subscript 10 is outside of an array of 4 elements"},
    {"clock[x] ? AFTER zero", "subscript 10 is outside of an array of 4 elements"},
};

std::string errors_in(const Executed& done) { return fmt::format("{}", fmt::join(done.errors, ", ")); }

} // namespace

TEST_CASE("a replicated PAR leaves the memory of others alone, whether or not its index is used") {
    for (const Component& component : replicated_components)
        for (const int count : {1, 2, 5})
            for (const bool vector_space : {true, false})
                for (const occam::ErrorMode mode : {occam::ErrorMode::halt, occam::ErrorMode::stop}) {
                    CAPTURE(component.text);
                    CAPTURE(count);
                    occam::CodeOptions options{.model = transputer::Model::t800, .mode = mode};
                    options.vector_space = vector_space;
                    const Executed done = execute(among_variables(component, count), options, worker);
                    CHECK(done.trouble == "");
                    CHECK(errors_in(done) == "");
                    CHECK(done.results[0] == 9);
                    CHECK(done.results[1] == 6);
                }
}

TEST_CASE("an error in the value of a name that is never used halts or stops as any other error") {
    for (const UnusedError& error : unused_errors)
        for (const occam::ErrorMode mode :
             {occam::ErrorMode::halt, occam::ErrorMode::stop, occam::ErrorMode::universal}) {
            CAPTURE(error.text);
            const Executed done = execute(timers_and_values + indented(error.text, 2) + "\n  memory[1] := 1\n",
                                          {.model = transputer::Model::t800, .mode = mode});
            CHECK(done.trouble == "");
            CHECK(done.halted == (mode != occam::ErrorMode::stop));
            CHECK(done.results[0] == 1);
            CHECK(done.results[1] == 0);
            CHECK(errors_in(done).find(error.said) != std::string::npos);
        }
}

TEST_CASE("retyped bytes are read from any address, and are changed only at the address of a word") {
    constexpr const char* bytes = R"([12]BYTE b:
INT from:
SEQ
  SEQ i = 0 FOR 12
    b[i] := BYTE i
  from := 1
)";
    const std::string reads = R"(  VAL INT x RETYPES [b FROM 1 FOR 4]:
  memory[0] := x
  VAL INT x RETYPES [b FROM from FOR 4]:
  memory[1] := x
  VAL [2]INT x RETYPES [b FROM from + 2 FOR 8]:
  memory[2] := x[1]
  INT x RETYPES [b FROM from + 3 FOR 4]:
  memory[3] := x
)";
    for (const bool vector_space : {true, false}) {
        occam::CodeOptions options{.model = transputer::Model::t800};
        options.vector_space = vector_space;
        const Executed done = execute(bytes + reads, options);
        CHECK(errors_in(done) == "");
        CHECK(done.results[0] == 0x04030201);
        CHECK(done.results[1] == 0x04030201);
        CHECK(done.results[2] == 0x0a090807);
        CHECK(done.results[3] == 0x07060504);
        for (const char* wrong :
             {"  INT x RETYPES [b FROM 1 FOR 4]:\n  x := 0\n", "  INT x RETYPES [b FROM from FOR 4]:\n  x := 0\n",
              "  VAL []INT x RETYPES [b FROM from FOR from + 7]:\n  memory[0] := x[0]\n"}) {
            CAPTURE(wrong);
            CHECK(errors_in(execute(std::string(bytes) + wrong, options)).find("is not a multiple of 4") !=
                  std::string::npos);
        }
    }
}
