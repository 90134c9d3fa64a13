// Tests the disassembler by the assembler of these tests, which shares no table with it.

#include "runtime/transputer/disassembler.hpp"

#include "random_program.hpp"
#include "runtime/transputer/assembler.hpp"
#include "runtime/transputer/code_text.hpp"
#include "tests/seeds.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <random>
#include <string>
#include <string_view>
#include <vector>

using namespace placedpar;
using namespace placedpar::test;
using transputer::assemble;
using transputer::CodeLine;
using transputer::Content;
using transputer::Model;

namespace {

using CodeBytes = std::vector<std::uint8_t>;

constexpr std::uint32_t code_at = 0x80000070;

std::string disassembled(std::string_view source) {
    const auto program = assemble(source, code_at);
    const std::uint32_t entry[] = {code_at};
    return transputer::print_memory(program.bytes, code_at, entry, Model::t800);
}

/// Returns the mnemonics of a line of source as instructions: an operation that fpentry selects is two.
std::string mnemonics_of(std::string source) {
    if (const auto colon = source.find(':'); colon != std::string::npos)
        source = source.substr(colon + 1);
    std::string result;
    for (std::size_t at = 0; at < source.size(); at = std::min(source.find(';', at), source.size() - 1) + 1) {
        at = std::min(source.find_first_not_of(" ;", at), source.size());
        const std::string word = source.substr(at, source.find_first_of(" ;\n", at) - at);
        if (!word.empty() && !word.starts_with('.'))
            result += (word.starts_with("fpu") ? "ldc fpentry" : word) + " ";
    }
    return result;
}

/// Returns the text that print_bootable() writes.
std::string printed_file(const CodeBytes& file, const transputer::FileRange& range = {}) {
    std::string text;
    transputer::print_bootable(file, Model::t800, range, [&](std::string_view part) { text += part; });
    return text;
}

/// Appends a packet: its length and its bytes.
void add_packet(CodeBytes& file, const CodeBytes& packet) {
    file.push_back(static_cast<std::uint8_t>(packet.size()));
    file.insert(file.end(), packet.begin(), packet.end());
}

} // namespace

TEST_CASE("code is followed over branches, calls, loops and processes; text between it is data") {
    // By the table: a prefix takes 1 cycle, ldc, ldlp and stl 1, ldl and ldnl 2, cj 2 or 4, lend 5 or 10, fpentry with
    // fpusqrtfirst 27, fpadd 6, in 19 and more.
    CHECK(disassembled(R"(
                 ldc 300
                 stl 1
        loop:    ldl 1
                 cj done
                 call sub
                 j loop
                 .byte 72, 101, 108, 108, 111, 44, 32, 119, 111, 114, 108, 100
        done:    ldc process - started
                 ldlp -20
                 startp
        started: ldlp 2
                 ldc after - started
                 lend
        after:   stopp
        sub:     ret
        process: ldc 1
                 fpentry
                 fpadd
                 ldlp 3
                 ldnl -2
                 ldc 4
                 in
                 endp
                 .word 0
                 opr #1FF
    )") == R"(  #80000070  21 22 4C            ldc     300             4
  #80000073  D1                  stl     1
  #80000074  71                  ldl     1               5-7
  #80000075  21 A0               cj      #80000087
  #80000077  21 98               call    #80000091       8
  #80000079  60 09               j       #80000074       4
  #8000007B  48 65 6C 6C 6F 2C 20 77  Hello, w
  #80000083  6F 72 6C 64              orld
  #80000087  48                  ldc     8               15
  #80000088  61 1C               ldlp    -20
  #8000008A  FD                  startp  #80000093
  #8000008B  12                  ldlp    2               8-13
  #8000008C  44                  ldc     4
  #8000008D  22 F1               lend    #8000008B
  #8000008F  21 F5               stopp                   12
  #80000091  22 F0               ret                     6
  #80000093  41                  ldc     1               73+
  #80000094  2A FB               fpentry fpusqrtfirst
  #80000096  28 F7               fpadd
  #80000098  13                  ldlp    3
  #80000099  60 3E               ldnl    -2
  #8000009B  44                  ldc     4
  #8000009C  F7                  in
  #8000009D  F3                  endp
  #8000009E  00 00 00 00 21 2F FF     ....!/.
)");
}

TEST_CASE("code that nothing leads to is searched and marked, and its beginning is the address that ldpi loads") {
    // ldpi refers to the byte after a pfix 0 that pads: read from there on, it would belong to the next instruction.
    const auto text = disassembled(R"(
                 ldc target - after
                 ldpi
        after:   stl 5
                 gcall
                 .byte #20
        target:  ldl 4
                 adc -1
                 stl 4
                 ldl 4
                 j target
    )");
    CHECK(text.find("  #80000075  20\n") != std::string::npos);
    CHECK(text.find("  #80000076  74                ? ldl     4               11\n") != std::string::npos);
    CHECK(text.find("? j       #80000076") != std::string::npos);
}

TEST_CASE("random programs are disassembled into the instructions that were assembled") {
    for (const auto seed : seeds(60)) {
        INFO(replay(seed));
        const auto code = random_code(seed, {.model = t805, .processes = seed % 3 != 0, .data_first = seed % 2 == 0});
        const auto program = assemble(code.source, code.origin);
        const std::uint32_t entry[] = {0};
        std::map<std::uint32_t, std::string> found; // mnemonics of followed code, by number of their bytes
        for (const CodeLine& line : transputer::disassemble(program.bytes, entry, Model::t805))
            if (line.content == Content::code) {
                const auto text = transputer::print_instruction(line.instruction, "");
                found[line.at] = text.substr(0, text.find(' ')) + ' ';
            }
        std::size_t followed = 0, all = 0;
        for (const transputer::Assembly::Line& line : program.lines) {
            const std::uint32_t begin = line.address - code.origin;
            const auto end = begin + static_cast<std::uint32_t>(line.bytes.size());
            all += line.bytes.size();
            if (!found.contains(begin))
                continue;
            followed += line.bytes.size();
            std::string mnemonics;
            for (auto at = found.lower_bound(begin); at != found.end() && at->first < end; ++at)
                mnemonics += at->second;
            CHECK(mnemonics == mnemonics_of(line.source));
        }
        CHECK(followed * 2 > all);
    }
}

TEST_CASE("packets of a bootable file are put together, and a branch over their ends has the right position") {
    CodeBytes file;
    add_packet(file, {0x41, 0x60, 0x0d}); // ldc 1; j to it
    CodeBytes first(60, 0x71), second(60, 0x72), last{0x73, 0x22, 0xf0};
    first[0] = 0x23; // j over 58 + 2 bytes: to the second byte of the second packet
    first[1] = 0x0b;
    for (const auto& packet : {first, second, last})
        add_packet(file, packet);
    file.push_back(0);
    const auto text = printed_file(file);
    CHECK(text.starts_with("\nloader: bytes +00001 to +00003\n"
                           "  #80000070  41                  ldc     1               5\n"
                           "  #80000071  60 0D               j       #80000070\n"
                           "\npackets: bytes +00005 to +00081, in packets of 60\n"
                           "  +00005     23 0B             ? j       +00043          4\n"));
    CHECK(text.find("  +00043     72                ? ldl     2 ") != std::string::npos);
    CHECK(text.ends_with("  +0007F     73                ? ldl     3\n"
                         "  +00080     22 F0             ? ret\n"
                         "\nother bytes: bytes +00082 to +00082\n"
                         "  +00082     00                ? j       outside +1      3\n"));
    CHECK(printed_file(file, {.from = 0x7f, .until = 0x80}) == "\npackets: bytes +00005 to +00081, in packets of 60\n"
                                                               "  +0007F     73                ? ldl     3\n");
}

TEST_CASE("any bytes are disassembled, each once") {
    for (const auto seed : seeds(300)) {
        INFO(replay(seed));
        std::mt19937_64 random(seed);
        CodeBytes bytes(random() % 700);
        const unsigned kinds = 1 + static_cast<unsigned>(random() % 256);
        for (auto& byte : bytes)
            byte = static_cast<std::uint8_t>(random() % kinds);
        const std::uint32_t entries[] = {static_cast<std::uint32_t>(random() % 800), 0, 0xffff'fff0};
        std::uint32_t at = 0;
        for (const CodeLine& line : transputer::disassemble(bytes, entries, Model::t414)) {
            REQUIRE(line.at == at);
            REQUIRE(line.instruction.length > 0);
            at += line.instruction.length;
        }
        CHECK(at == bytes.size());
        printed_file(bytes);
    }
}
