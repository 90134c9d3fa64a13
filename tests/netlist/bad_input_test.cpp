// Tests input that cannot be a netlist, or is huge: one clear diagnostic, in little time.

#include "netlist/language/parser.hpp"
#include "netlist/read.hpp"
#include "tests/netlist/small_catalogue.hpp"
#include "tests/sanitized.hpp"
#include "text/load_source.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

using namespace placedpar;

namespace {

std::string first_message(const ReadResult& result) {
    CHECK_FALSE(result.network);
    return result.diagnostics.empty() ? "" : result.diagnostics[0].message;
}

std::string refused(const std::string& text, const Overrides& overrides = {}) {
    return first_message(read_netlist_text(text, small_catalogue(), overrides));
}

std::string repeated(const std::string& text, int times) {
    std::string result;
    for (int i = 0; i < times; ++i)
        result += text;
    return result;
}

/// Returns ", n1 = 0, n2 = 0", from `first` up to but not including `last`, one a line.
std::string numbered(int first, int last) {
    std::string result;
    for (int i = first; i < last; ++i)
        result += ",\nn" + std::to_string(i) + " = 0";
    return result;
}

} // namespace

TEST_CASE("a file that is not text is refused") {
    auto folder = std::filesystem::temp_directory_path() / "placedpar_bad_input_test";
    std::filesystem::create_directories(folder);
    CHECK(first_message(read_netlist(folder / "nothing.cfs", small_catalogue())) == "this file does not exist");
    CHECK(first_message(read_netlist(folder, small_catalogue())) == "this is a directory, not a file");
    CHECK(first_message(read_netlist("/dev/null", small_catalogue())) == "this is neither a file nor a pipe");
    CHECK(
        first_message(read_netlist(std::string(5000, 'x'), small_catalogue())).starts_with("the file cannot be read"));
    std::ofstream(folder / "large.cfs") << std::string(largest_source_bytes + 10, ' ');
    CHECK(first_message(read_netlist(folder / "large.cfs", small_catalogue())).starts_with("the file is too large"));
    std::filesystem::remove_all(folder);
}

TEST_CASE("a netlist of many large files is refused before it fills the memory" * doctest::skip(test::sanitized)) {
    auto folder = std::filesystem::temp_directory_path() / "placedpar_many_large_files_test";
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "large.cfs") << repeated(std::string(999, ' ') + "\n", 15'000);
    std::ofstream main(folder / "main.cfs");
    main << repeated("#include \"large.cfs\"\n", 5);
    main.close();
    auto path = folder / "main.cfs";
    auto result = read_netlist(path, small_catalogue());
    std::filesystem::remove_all(folder);
    CHECK(first_message(result) == "the netlist includes more than 67108864 bytes");
    CHECK(result.diagnostics.at(0).location.text() == path.string() + ":5:10");
}

TEST_CASE("binary content is refused") {
    auto result = read_netlist_text(std::string("T800 a;\n\tval \0 x", 16), small_catalogue());
    CHECK(first_message(result) == "this is a binary file, not text: it contains the byte 0x00");
    REQUIRE(result.diagnostics.size() == 1);
    CHECK(result.diagnostics[0].location.text() == "netlist:2:6");
    CHECK(render(result.diagnostics) ==
          "netlist:2:6: error: this is a binary file, not text: it contains the byte 0x00\n"
          "    \tval \\x00 x\n"
          "    \t    ^\n");
    CHECK(refused("\x7f\x45\x4c\x46").starts_with("this is a binary file, not text"));
    CHECK(refused("val \xff 5;") == "illegal character byte 0xff");
}

TEST_CASE("an empty file is an empty network") {
    CHECK(read_netlist_text("", small_catalogue()).network);
    CHECK(read_netlist_text("\xef\xbb\xbf/* nothing */", small_catalogue()).network);
}

TEST_CASE("overlong lines, too many words and too deep nesting are refused") {
    CHECK(refused("val x " + std::string(20000, '1') + ";").starts_with("the line is too long"));
    CHECK(refused(repeated("val\n", 100)) != "");
    CHECK(refused(repeated("{", 5000)).starts_with("the nesting is too deep"));
    CHECK(refused("val x " + repeated("(", 5000)).starts_with("the nesting is too deep"));
    CHECK(refused("val x " + repeated("-", 5000) + "1;").starts_with("the nesting is too deep"));
    CHECK(refused("val x " + repeated("!(", 4000) + "1;").starts_with("the nesting is too deep"));
    CHECK(refused("val x " + repeated("{", 5000)).starts_with("the nesting is too deep"));
    CHECK(refused(repeated("if 1\n", 50000) + ";").starts_with("the nesting is too deep"));
    CHECK(refused("val x 1" + repeated("\n+ 1", 100000) + ";").starts_with("the expression is too long"));
    CHECK(refused("val x 1" + repeated("\n[1]", 100000) + ";").starts_with("the expression is too long"));
    CHECK(refused("process (" + repeated("order (\n", 5000) + ";").starts_with("the nesting is too deep"));
    CHECK(refused("val s \"" + std::string(5000, 'x') + "\";").starts_with("the string is too long"));
    if (!test::sanitized)
        CHECK(refused(repeated("{}\n", 4100000)).starts_with("the netlist is too large"));
}

TEST_CASE("too many replications and too large arrays are refused" * doctest::skip(test::sanitized)) {
    CHECK(refused("rep i = 0 for 9223372036854775807 ;").find("takes more than") != std::string::npos);
    CHECK(refused("rep i = 1 for 9223372036854775807 ;") == "1 + 9223372036854775807 does not fit in 64 bits");
    CHECK(refused("rep a = 0 for 3000 rep b = 0 for 3000 { val x a + b; }").find("takes more than") !=
          std::string::npos);
    CHECK(refused("T800 t[1000][1000];").find("the array is too large") != std::string::npos);
    CHECK(refused("T800 t[4611686018427387904][4];").find("the array is too large") != std::string::npos);
    CHECK(refused("rep i = 0 for 1000000 T800 t;").starts_with("the network is too large"));
    CHECK(refused("process (interface (input in[200000])) p[200000];").starts_with("the network is too large"));
    auto many =
        read_netlist_text("T800 t; process p[100000]; rep i = 0 for 100000 place p[i] on t;", small_catalogue());
    CHECK(many.network.has_value());
    std::string doubling = "val a0 {1, 1};";
    for (int i = 1; i < 60; ++i)
        doubling +=
            "val a" + std::to_string(i) + " {a" + std::to_string(i - 1) + ", a" + std::to_string(i - 1) + "};\n";
    CHECK(refused(doubling).starts_with("the array has too many dimensions"));
    std::string wide = "process (interface (int n";
    for (int i = 0; i < 2000; ++i)
        wide += ",\nint n" + std::to_string(i);
    CHECK(refused(wide + ")) p;").starts_with("the interface is too large"));
    CHECK(refused("rep i = 0 for 1000000 { val n undefined_name; }") == "the name \"undefined_name\" is undefined");
    CHECK(read_netlist_text("val n 1" + repeated("\n+ 1", 900) + "; if n == 901 T800 t;", small_catalogue())
              .network.value()
              .nodes.size() == 1);
}

TEST_CASE("the elaboration of a refused netlist is bounded") {
    auto result = read_netlist_text("T800 t[1000000];\n"
                                    "rep i = 0 for 1000000 rep k = 0 for 1000000 connect t[i].link[k] to t[k].link[i];",
                                    small_catalogue());
    CHECK(first_message(result).find("the array is too large") != std::string::npos);
    CHECK(render(result.diagnostics).find("takes more than") == std::string::npos);
}

TEST_CASE("at most twenty errors are reported") {
    auto result = read_netlist_text(repeated("val x;\n", 500), small_catalogue());
    CHECK_FALSE(result.network);
    CHECK(result.diagnostics.size() == 20);
    CHECK(result.not_shown == "... 480 more errors not shown\n");
    CHECK(render(result).ends_with("\n... 480 more errors not shown\n"));
    CHECK(read_netlist_text(repeated("val x;\n", 20), small_catalogue()).not_shown.empty());
    CHECK(read_netlist_text(repeated("val x;\n", 21), small_catalogue()).not_shown == "... 1 more error not shown\n");
    CHECK(read_netlist_text(repeated("val x;\n", 5000), small_catalogue()).not_shown ==
          "... 980 more errors not shown\n");
}

TEST_CASE("netlists just within the bounds of the language reference are read" * doctest::skip(test::sanitized)) {
    auto read = [](const std::string& text) { return read_netlist_text(text, small_catalogue()).network.has_value(); };
    auto array = [](int depth) { return "val a " + repeated("{", depth) + "1" + repeated("}", depth) + ";"; };
    auto nested = [](const std::string& open, const std::string& inner, const std::string& close, int depth) {
        return repeated(open, depth) + inner + repeated(close, depth);
    };
    CHECK(read("/*" + std::string(9996, 'x') + "*/\r\n"));
    CHECK_FALSE(read("/*" + std::string(9997, 'x') + "*/\r\n"));
    CHECK(read("val s \"" + std::string(2000, 'x') + "\";"));
    CHECK_FALSE(read("val s \"" + std::string(2001, 'x') + "\";"));
    CHECK(read(array(8)));
    CHECK_FALSE(read(array(9)));
    for (const auto& braces : {std::pair("{", "}"), std::pair("rep i = 0 for 1 {", "}"), std::pair("if 1\n", "")}) {
        CAPTURE(braces.first);
        CHECK(read(nested(braces.first, "val n 1;", braces.second, 200)));
        CHECK_FALSE(read(nested(braces.first, "val n 1;", braces.second, 201)));
    }
    CHECK(read("val n " + nested("(", "1", ")", 200) + ";"));
    CHECK_FALSE(read("val n " + nested("(", "1", ")", 201) + ";"));
    CHECK(read("val n 1" + repeated("\n+ 1", 1000) + ";"));
    CHECK_FALSE(read("val n 1" + repeated("\n+ 1", 1001) + ";"));
    CHECK(read("process (interface (int n0 = 0" + numbered(1, 1000) + ")) p; T800 t; place p on t;"));
    CHECK_FALSE(read("process (interface (int n0 = 0" + numbered(1, 1001) + ")) p; T800 t; place p on t;"));
    CHECK(read("connection c[250000];"));
    CHECK_FALSE(read("connection c[250000], d;"));
}

TEST_CASE("a channel end that is placed and connected counts once" * doctest::skip(test::sanitized)) {
    auto text = "T800 t; process p, q; place p on t; place q on t; rep i = 0 for 83334 {\n"
                "place p.out[i] on t.link[0];\nconnect p.out[i] to q.in[i]; }";
    CHECK(render(read_netlist_text(text, small_catalogue())).find("too large") == std::string::npos);
}

TEST_CASE("wrong overrides are refused") {
    CHECK(refused("val n 1;", {{"m", "1"}}) == "the netlist has no val, attribute or parameter \"m\"");
    CHECK(refused("val n 1;", {{"n", ""}}) == "the value is missing");
    CHECK(refused("val n 1;", {{"n", "1 2"}}).starts_with("illegal token after an expression"));
    CHECK(refused("val n 1;", {{"n", "\"a\""}}).starts_with("wrong type for the val"));
    CHECK(refused("val n 1;", {{"", "5"}}).starts_with("the name of a val, an attribute or a parameter is missing"));
    CHECK(refused("val n 1;", {{"n n", "5"}}).starts_with("\"=\" is missing"));
    CHECK(refused("val n 1;", {{"n@", "5"}}) == "illegal character \"@\"");
    CHECK(refused("val n 1;", {{"@", "5"}}) == "illegal character \"@\"");
    CHECK(refused("val n 1;", {{"for", "5"}}).find("is a word of the language") != std::string::npos);
    CHECK(refused("{ val n 1; }", {{"n", "5"}}) == "the val \"n\" is declared in a block");
    CHECK(refused("{ val n {1, 2}; }", {{"n[0]", "5"}}) == "the val \"n\" is declared in a block");
    CHECK(refused("val n {1, 2};", {{"n[0]", "5"}}) == "the val \"n\" can be set only as a whole, not by element");
    CHECK(refused("val n 1;", {{"n", std::string("1\0", 2)}}).starts_with("this is a binary file, not text"));
}

TEST_CASE("a caret stands at its column despite tabs, other alphabets and long lines") {
    auto shown = [](const std::string& text) { return render(read_netlist_text(text, small_catalogue()).diagnostics); };
    CHECK(shown("val s \"\xc3\xa4\xc3\xb6\" @;").find("\n    val s \"\xc3\xa4\xc3\xb6\" @;\n               ^\n") !=
          std::string::npos);
    auto lines = shown("val x " + repeated("1 +", 200) + " @ " + repeated(" + 1", 200) + ";");
    auto excerpt = lines.find("    ...");
    REQUIRE(excerpt != std::string::npos);
    auto caret = lines.find('^'), at = lines.find('@', excerpt);
    CHECK(caret - (lines.rfind('\n', caret) + 1) == at - (lines.rfind('\n', at) + 1));
}

TEST_CASE("a name is one word that begins with a letter and is not reserved") {
    for (const char* name : {"RING", "t800", "_x", "ring_2"})
        CHECK(can_be_a_name(name));
    for (const char* name : {"", "place", "for", "my ring", "3ring", "ring-2", "a.b"})
        CHECK_FALSE(can_be_a_name(name));
}
