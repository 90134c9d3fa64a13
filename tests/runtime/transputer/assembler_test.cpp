// Tests of the assembler by the databook's examples, and by the plain transputer, which has a table of its own.

#include "edges.hpp"
#include "plain_transputer.hpp"
#include "runtime/transputer/assembler.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

using namespace placedpar::test;
using placedpar::transputer::assemble;
using placedpar::transputer::AssemblyError;
using placedpar::transputer::encoded;

namespace {

using Code = std::vector<std::uint8_t>;

/// Returns the place and the text of the error in a program; "" if it has none.
std::string assembly_error(const char* source, std::optional<placedpar::transputer::Model> model = std::nullopt) {
    try {
        assemble(source, 0, model);
    } catch (const AssemblyError& error) {
        return fmt::format("{}:{}: {}", error.line, error.column, error.what());
    }
    return "";
}

} // namespace

TEST_CASE("the assembler makes the shortest code for each operand") {
    CHECK(assemble("ldc #754").bytes == Code{0x27, 0x25, 0x44}); // the databook's examples
    CHECK(assemble("ldc -31").bytes == Code{0x61, 0x41});
    CHECK(assemble("ldc -1").bytes == Code{0x60, 0x4F});
    CHECK(assemble("ldc -256").bytes == Code{0x6F, 0x40});
    CHECK(assemble("mint\nadd").bytes == Code{0x24, 0xF2, 0xF5});
    CHECK(assemble("fpusqrtfirst").bytes == Code{0x41, 0x2A, 0xFB});
    CHECK(assemble("here: j here").bytes == Code{0x60, 0x0E});
    CHECK(assemble("j next\nldc 0\nnext: .word next - 1").bytes == Code{0x01, 0x40, 1, 0, 0, 0});
    for (const auto value : edges())
        for (std::size_t least : {1U, 3U, 8U}) {
            PlainTransputer t({.memory = 4096});
            const auto code = encoded(4, static_cast<std::int32_t>(value), least);
            t.poke(t.iptr, code);
            CHECK(t.step() == 2 * code.size());
            CHECK(t.a == value);
        }
}

TEST_CASE("the assembler and the plain transputer give an operation the same code") {
    for (const auto& table : {plain_integer_operations, plain_scheduling_operations})
        for (const auto& row : table)
            CHECK_MESSAGE(assemble(row.name).bytes == encoded(15, static_cast<std::int32_t>(row.code)), row.name);
    for (const auto& row : plain_real_operations)
        CHECK_MESSAGE(assemble(row.name).bytes.back() >= 0xF0, row.name);
}

TEST_CASE("the assembler stores numbers, texts and what fills a word") {
    CHECK(assemble(".byte 1, -1, 255").bytes == Code{1, 255, 255});
    CHECK(assemble(".half 258; .word -2").bytes == Code{2, 1, 0xFE, 0xFF, 0xFF, 0xFF});
    CHECK(assemble(".byte \"a; b -- c:\", 13 -- text").bytes ==
          Code{'a', ';', ' ', 'b', ' ', '-', '-', ' ', 'c', ':', 13});
    CHECK(assemble(".byte 1; .align; .byte 2", 0x80000071).bytes == Code{1, 0, 0, 2});
    CHECK(assemble("two = 2\nthree = two + 1\nldc three - #1; adc two").bytes == Code{0x42, 0x82});
}

TEST_CASE("the assembler's listing has the address and the bytes of each line") {
    CHECK(assemble("-- two lines\nstart: ldc 300; dup\n.byte \"012345678\"", 0x80000070).listing() ==
          "                                   -- two lines\n"
          "80000070  21 22 4C 25 FA           start: ldc 300; dup\n"
          "80000075  30 31 32 33 34 35 36 37  .byte \"012345678\"\n"
          "8000007D  38\n");
}

TEST_CASE("the assembler says where an error is") {
    CHECK(assembly_error("ldc 1\nadd 3") == "2:5: \"add\" has no operand");
    CHECK(assembly_error("\n\n  rev; frob") == "3:8: the instruction \"frob\" does not exist");
    CHECK(assembly_error("j nowhere") == "1:3: no label and no number has the name \"nowhere\"");
    CHECK(assembly_error("x:\nx: rev") == "2:1: \"x\" is defined already: choose another name");
    CHECK(assembly_error("x: rev\nx = 1") == "2:1: \"x\" is defined already: choose another name");
    CHECK(assembly_error("1x: rev") == "1:1: \"1x\" cannot be a name: a name has letters, digits, _ and .");
    CHECK(assembly_error("x = y") == "1:5: no label and no number has the name \"y\"");
    CHECK(assembly_error("ldc") == "1:1: \"ldc\" needs an operand");
    CHECK(assembly_error("ldc 4294967296") == "1:5: \"4294967296\" is neither a number of 32 bits nor a name");
    CHECK(assembly_error(".byte 1, 256") == "1:10: 256 does not fit into 8 bits");
    CHECK(assembly_error(".byte -129") == "1:7: -129 does not fit into 8 bits");
    CHECK(assembly_error(".word") == "1:6: a number or a name is missing");
    CHECK(assembly_error("dup", placedpar::transputer::Model::t800) == "");
    CHECK(assembly_error("dup", placedpar::transputer::Model::t414) == "1:1: the T414 has no instruction \"dup\"");
}
