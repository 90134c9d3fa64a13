// Tests what is said about errors of code, with and without a compiler's table.

#include "runtime/transputer/error_text.hpp"

#include "node_world.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

using namespace placedpar;
using namespace placedpar::test;
using transputer::CodeLines;

namespace {

/// Runs a program until an error halts it, and returns what is said about it.
std::string said(const std::string& source) {
    NodeWorld world;
    transputer::Node& node = world.node("t", {});
    world.run_at_boot(node, "sethalterr; " + source);
    world.run();
    REQUIRE(node.core().stopped() == transputer::Stopped::by_error);
    return print_error(node.core(), node.core().error(), CodeLines());
}

} // namespace

TEST_CASE("an error of an instruction is told with what it found") {
    CHECK_EQ(said("ldc 7; ldc 0; div"), "division by zero: 7 / 0");
    CHECK_EQ(said("mint; ldc -1; div"), "overflow: -2147483648 / -1");
    CHECK_EQ(said("ldc -7; ldc 0; rem"), "division by zero: -7 \\ 0");
    CHECK_EQ(said("ldc #7FFFFFFF; ldc 1; add"), "overflow: 2147483647 + 1");
    CHECK_EQ(said("ldc #7FFFFFFF; adc 5"), "overflow: 2147483647 + 5");
    CHECK_EQ(said("mint; adc -5"), "overflow: -2147483648 - 5");
    CHECK_EQ(said("ldc 1; mint; sub"), "overflow: 1 - -2147483648");
    CHECK_EQ(said("ldc #10000; ldc #10000; mul"), "overflow: 65536 * 65536");
    CHECK_EQ(said("mint; mint; fmul"), "overflow of the product of two fractions, -2147483648 and -2147483648");
    CHECK_EQ(said("ldc 10; ldc 8; csub0"), "10 is outside of the range 0 to 7");
    CHECK_EQ(said("ldc 9; ldc 8; ccnt1"), "9 is outside of the range 1 to 8");
    CHECK_EQ(said("ldc 1; ldc 5; ldc 0; ldiv"), "division by zero");
    CHECK_EQ(said("ldc 300; ldc #80; cword"), "300 is outside of the range -128 to 127");
    CHECK_EQ(said("ldc 1; ldc 0; csngl"), "a double word does not fit in a word");
    CHECK_EQ(said("ldc 0; ldc #7FFFFFFF; ldc 1; ladd"), "overflow of the upper words: 2147483647 + 1");
    CHECK_EQ(said("seterr"), "the program has set the Error flag");
    CHECK_EQ(said("ldc #23; fpentry; fpchkerror"),
             "an operation on reals: overflow, division by zero, an infinity or a NaN");
}

TEST_CASE("a table's text has registers and words of the workspace in it") {
    NodeWorld world;
    transputer::Node& node = world.node("t", {});
    world.run_at_boot(node, "sethalterr; ldc 5; stl 2; ldc -1; stl 3; ldc 1; ldc -2; ldc 3; seterr");
    world.run();
    const transputer::ErrorNote& error = node.core().error();
    const auto with = [&](const std::string& text) {
        const CodeLines lines(fmt::format("error #{:X} {}\nend", error.after, text), "", from_start(0x70));
        return print_error(node.core(), error, lines);
    };
    const std::string found = with("a {a}, b {b}, c {c}, {a-1} {b+4}, {w+2}, {l+2}, {ba}; {d} {} {a*2} {w");
    CHECK_EQ(found, "a 3, b -2, c 1, 2 2, 5, -4294967291, -8589934589; {d} {} {a*2} {w");
    CHECK_EQ(with("{/w+2}: {w+2}, {/w+4}: {w+4}, {/}"), "overflow: 5, division by zero: 0, {/}");
}

TEST_CASE("processes that stoperr stops are listed, and a core that goes on is not halted") {
    NodeWorld world;
    transputer::Node& node = world.node("t", {});
    world.run_at_boot(node, R"(
        clrhalterr; testerr
        ldc other - after; ldlp -20; startp
after:  ldc 1; ldc 0; div; stoperr; stopp
other:  testerr; ldc 9; ldc 8; csub0; stoperr; stopp
    )");
    world.run();
    CHECK(node.core().stopped() == transputer::Stopped::nothing);
    std::vector<std::string> texts;
    for (const auto& each : node.core().stopped_processes())
        texts.push_back(print_error(node.core(), each.error, {}));
    CHECK(texts == std::vector<std::string>{"division by zero: 1 / 0", "9 is outside of the range 0 to 7"});
    CHECK_EQ(node.core().count_stopped(), 2);
    CHECK(node.core().stopped_processes()[0].at < node.core().stopped_processes()[1].at);
}

TEST_CASE("an error of a routine is told of its call, along the return addresses that texts name") {
    NodeWorld world;
    transputer::Node& node = world.node("t", {});
    world.run_at_boot(node, R"(
        sethalterr; ldc 7; call outer; stopp
outer:  ajw -3; ldc 0; stl 1; call inner; ajw 3; ret
inner:  ajw -5; seterr; ajw 5; ret
    )");
    world.run();
    const transputer::ErrorNote& error = node.core().error();
    const auto return_address = [&](transputer::Word words) {
        return node.core().memory().word(transputer::NodeMemory::offset_of(error.workspace) + 4 * words);
    };
    const CodeLines lines(fmt::format("error #{:X} called from {{w+5}}\nerror #{:X} called from {{w+3}}\n"
                                      "error #{:X} outer has failed\nend",
                                      error.after, return_address(5), return_address(12)),
                          "", from_start(0x70));
    const transputer::ErrorNote named = error_to_name(node.core(), error, lines);
    CHECK_EQ(named.after, return_address(12));
    CHECK_EQ(named.workspace, error.workspace + 4 * 16);
    CHECK_EQ(print_error(node.core(), named, lines), "outer has failed");
    const CodeLines circle(fmt::format("error #{:X} called from {{w-2000000}}\nend", error.after), "",
                           from_start(0x70));
    CHECK_EQ(error_to_name(node.core(), error, circle).after, error.after);
}
