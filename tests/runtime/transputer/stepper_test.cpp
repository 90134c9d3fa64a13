// Compares what the stepper prints with known states.

#include "runtime/transputer/stepper.hpp"

#include "runtime/transputer/assembler.hpp"

#include <doctest/doctest.h>

#include <sstream>
#include <string>
#include <string_view>

using namespace placedpar;
using transputer::assemble;
using transputer::Core;

namespace {

struct UnusedLinks : transputer::LinkEngines {
    void begin_transfer(int, std::uint32_t, std::uint32_t) override {}
    bool byte_waits(int) override { return false; }
    void reset(int) override {}
};

/// Returns what the stepper prints for a program and a script. "|" stands for the end of the run by the stepper.
std::string stepped(std::string_view source, const std::string& script) {
    constexpr std::uint32_t at = 0x80000100, workspace = 0x80000200;
    UnusedLinks links;
    Core core(transputer::Model::t800, 4096, {}, links);
    core.copy_to_memory(at - transputer::most_negative, assemble(source, at).bytes);
    core.set_registers({.instruction = at, .workspace = workspace}, 1);
    std::istringstream commands(script);
    std::string printed;
    const transputer::CodeLines none;
    transputer::Stepper stepper(core, none, commands, [&](std::string_view text) { printed += text; });
    return core.run(1'000'000) == Core::Pause::left ? printed + "|" : printed;
}

constexpr std::string_view counting = R"(
         mint
         stlf
         ldc 3
         stl 1
 loop:   ldl 1
         adc -1
         stl 1
         ldl 1
         cj done
         j loop
 done:   ldc other - started
         ldlp 20
         startp
 started: stopp
 other:  stopp
)";

} // namespace

// Times are cycles of 50 ns: the four instructions before the loop take 6 cycles by the table.

TEST_CASE("the stepper executes single instructions and shows code, workspace and memory") {
    CHECK(stepped(counting, "l 7\ns 4\nw 1\ns\nm #80000204 1\nquit\ns\n") ==
          "0 ps  #80000100  24 F2  mint\n"
          "  #80000100  24 F2               mint                    6\n"
          "  #80000102  21 FC               stlf\n"
          "  #80000104  43                  ldc     3\n"
          "  #80000105  D1                  stl     1\n"
          "  #80000106  71                  ldl     1               9-11\n"
          "  #80000107  60 8F               adc     -1\n"
          "  #80000109  D1                  stl     1\n"
          "300.000 ns  #80000106  71  ldl     1\n"
          "W-5 #800001EC  #00000000            0\n"
          "W-4 #800001F0  #00000000            0\n"
          "W-3 #800001F4  #00000000            0\n"
          "W-2 #800001F8  #00000000            0\n"
          "W-1 #800001FC  #00000000            0\n"
          "W+0 #80000200  #00000000            0\n"
          "W+1 #80000204  #00000003            3\n"
          "400.000 ns  #80000107  60 8F  adc     -1\n"
          "#80000204  #00000003            3\n"
          "|");
}

TEST_CASE("the stepper stops at breakpoints and shows registers and queues") {
    CHECK(stepped(counting, "b #80000109\nc\nr\nc\nb 80000109\nb #80000112\nc\nq\n") ==
          "0 ps  #80000100  24 F2  mint\n"
          "breakpoints: #80000109\n"
          "500.000 ns  #80000109  D1  stl     1\n"
          "Iptr #80000109  Wptr #80000200  priority low, no Error\n"
          "A #00000002            2  B #00000000            0  C #00000000            0\n"
          "clocks: high 0, low 0\n"
          "FA 0 (REAL32)  FB 0 (REAL32)  FC 0 (REAL32)\n"
          "1.150000 us  #80000109  D1  stl     1\n"
          "breakpoints: none\n"
          "breakpoints: #80000112\n"
          "2.900000 us  #80000112  21 F5  stopp\n"
          "high priority: empty\n"
          "low priority:\n"
          "  Wptr #80000250  Iptr #80000114\n"
          "timer, high: empty\n"
          "timer, low: empty\n"
          "|");
}

TEST_CASE("the stepper names what it does not understand, and a queue in a circle has an end") {
    const std::string text = stepped(counting, "fly\nb 12x\nm 0\ns 0\n");
    CHECK(text.find("\"fly\" is not a command. The commands are:\ns [N] ") != std::string::npos);
    CHECK(text.find("\"12x\" is not an address such as #80000070\n") != std::string::npos);
    CHECK(text.find("#00000000 is outside of the memory\n") != std::string::npos);
    CHECK(text.find("\"s 0\" is not a command") != std::string::npos);
    const std::string circle = stepped(R"(
         ldlp 20
         stl 18
         ldlp 20
         stlf
         stopp
    )",
                                       "s 4\nq\n");
    CHECK(circle.size() < 100'000);
    CHECK(circle.find("low priority:\n  Wptr #80000250") != std::string::npos);
}
