// Tests the tables of code and processes that a compiler writes beside a bootable file.

#include "runtime/transputer/code_lines.hpp"

#include "runtime/random.hpp"
#include "tests/seeds.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

using namespace placedpar;
using namespace placedpar::test;
using transputer::CodeLines;
using transputer::CodeLinesError;

namespace {

constexpr std::uint32_t start_of_memory = 0x80000070;
constexpr std::string_view table = R"(-- made by a compiler
code +#00 +#0C 3 5 my ring.occ
code #80000080 #80000090 4 1 my ring.occ

entry +#00 main
entry +#10 philosopher
error +#08 subscript {b} is outside of an array of {a} elements
process +#100 +#180 phil[0]
process +#180 +#200 phil[1]
node worker
code +#00 +#08 9 1 worker.occ
process #80000200 #80000210 loader
carrier #80000210 #80000220 mux of link[1]
channel #80000004 p.out -> q.in
channel #80000300 p.more -> q.more
end
)";

/// Returns what is wrong with a table, and where: "3:6: ...".
std::string refusal(const std::string& text) {
    try {
        CodeLines(text, "", start_of_memory);
    } catch (const CodeLinesError& error) {
        return fmt::format("{}:{}: {}", error.line, error.column, error.what());
    }
    return "";
}

} // namespace

TEST_CASE("a table tells places, procedures and processes of each node") {
    const CodeLines root(table, "", start_of_memory), worker(table, "worker", start_of_memory);
    CHECK_EQ(root.place(0x80000070), "my ring.occ:3:5");
    CHECK_EQ(root.place(0x8000007B), "my ring.occ:3:5");
    CHECK_EQ(root.place(0x8000007C), "main+#C");
    CHECK_EQ(root.file_place(0x8000007C), "");
    CHECK_EQ(root.place(0x80000080), "my ring.occ:4:1");
    CHECK_EQ(root.place(0x80000091), "philosopher+#11");
    CHECK_EQ(root.place(0x8000006F), "");
    CHECK_EQ(root.error(0x80000078), "subscript {b} is outside of an array of {a} elements");
    CHECK_EQ(root.error(0x80000077), "");
    CHECK_EQ(root.error(0x80000079), "");
    CHECK_EQ(root.entry(0x80000080), "philosopher");
    CHECK_EQ(root.entry(0x80000081), "");
    CHECK_EQ(root.process(0x800001EC), "phil[0]");
    CHECK_EQ(root.process(0x800001F0), "phil[1]");
    CHECK_EQ(root.process(0x80000270), "");
    CHECK_EQ(root.process(0x80000010), "");
    CHECK_EQ(worker.place(0x80000070), "worker.occ:9:1");
    CHECK_EQ(worker.process(0x80000200), "loader");
    CHECK_EQ(worker.process(0x8000021C), "mux of link[1]");
    CHECK(worker.is_carrier(0x8000021C));
    CHECK_FALSE(worker.is_carrier(0x80000220));
    CHECK_FALSE(worker.is_carrier(0x80000200));
    CHECK_EQ(worker.channel(0x80000004), "p.out -> q.in");
    CHECK_EQ(worker.channel(0x80000300), "p.more -> q.more");
    CHECK_EQ(worker.channel(0x80000304), "");
    CHECK_EQ(worker.channel(0x80000000), "");
    CHECK_EQ(CodeLines(table, "another", start_of_memory).place(0x80000070), "");
}

TEST_CASE("a wrong table is refused with its place") {
    CHECK_EQ(refusal(""), "1:1: the table is cut off: its last row must be \"end\"");
    CHECK_EQ(refusal("entry +#0 a\n"), "2:1: the table is cut off: its last row must be \"end\"");
    CHECK_EQ(refusal("code +#0 +#4 1\nend"), "1:15: the row is cut off: it has no COLUMN");
    CHECK_EQ(refusal("code +#0 +#4 1 1  \nend"), "1:19: the row is cut off: it has no FILE");
    CHECK_EQ(refusal("code 12 +#4 1 1 f\nend"),
             "1:6: FROM is not an address such as #80000170, or an offset from MemStart such as +#100");
    CHECK_EQ(refusal("code #100 +#4 1 1 f\nend"),
             "1:6: FROM is not an address such as #80000170, or an offset from MemStart such as +#100");
    CHECK_EQ(refusal("code +#0 +#FFFFFFFF 1 1 f\nend"),
             "1:10: UNTIL is not an address such as #80000170, or an offset from MemStart such as +#100");
    CHECK_EQ(refusal("code +#0 +#4 0 1 f\nend"), "1:14: LINE is not a whole number of at least 1");
    CHECK_EQ(refusal("code +#0 +#4 1 -1 f\nend"), "1:16: COLUMN is not a whole number of at least 1");
    CHECK_EQ(refusal("code +#4 +#4 1 1 f\nend"), "1:1: UNTIL is not after FROM");
    CHECK_EQ(refusal("code +#4 +#8 1 1 f\ncode +#0 +#5 1 1 f\nend"),
             "2:1: the row has an address that the row in line 1 has already");
    CHECK_EQ(refusal("process +#4 +#8 a\nprocess +#4 +#5 b\nend"),
             "2:1: the row has an address that the row in line 1 has already");
    CHECK_EQ(refusal("entry +#4 a\nentry +#4 b\nend"),
             "2:1: the row has an address that the row in line 1 has already");
    CHECK_EQ(refusal("error +#4 a\nerror +#4 b\nend"),
             "2:1: the row has an address that the row in line 1 has already");
    CHECK_EQ(refusal("node a\nnode a\nend"), "2:1: the node \"a\" has rows already: put all rows of a node together");
    CHECK_EQ(refusal("line +#4 a\nend"),
             "1:1: a row begins with code, entry, process, carrier, channel, error, node or end");
    CHECK_EQ(refusal("entry +#4 a\x1b[2J\nend"), "1:11: NAME has a control character");
    CHECK_EQ(refusal("entry +#4 " + std::string(201, 'a') + "\nend"), "1:11: NAME has more than 200 bytes");
    CHECK_EQ(refusal("end now"), "1:5: the row is complete before this word: delete the rest of the line");
    CHECK_EQ(refusal("end\nwhat follows is not read"), "");
}

TEST_CASE("damaged tables are read, or refused with a place in the text") {
    std::size_t refused = 0;
    for (const std::uint64_t seed : seeds(3000)) {
        INFO(replay(seed));
        RandomStream random(seed, "damage");
        std::string text(table);
        for (std::uint64_t i = 0, changes = 1 + random.below(4); i < changes && !text.empty(); ++i) {
            const auto size = static_cast<std::uint32_t>(text.size());
            const std::size_t at = random.below(size);
            switch (random.below(4)) {
            case 0: text[at] = static_cast<char>(random.below(256)); break;
            case 1: text.erase(at, 1 + random.below(12)); break;
            case 2: text.insert(at, text.substr(random.below(size), random.below(30))); break;
            default: text.resize(at); break;
            }
        }
        CAPTURE(text);
        try {
            const CodeLines lines(text, seed % 2 ? "worker" : "", start_of_memory);
            for (std::uint32_t address = start_of_memory; address < start_of_memory + 0x40; ++address)
                CHECK_LE(lines.place(address).size() + lines.process(address).size(), 700);
        } catch (const CodeLinesError& error) {
            ++refused;
            const auto count = static_cast<std::size_t>(std::ranges::count(text, '\n')) + 1;
            CHECK_GE(error.line, 1);
            CHECK_LE(error.line, count + 1);
            CHECK_GE(error.column, 1);
            CHECK_LE(error.column, text.size() + 1);
        }
    }
    if (all_seeds())
        CHECK_GT(refused, 1000);
}
