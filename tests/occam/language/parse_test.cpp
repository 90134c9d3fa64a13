// Known answers: what is read as what.

#include "tests/occam/language/print.hpp"
#include "tests/occam/language/read_text.hpp"

#include <doctest/doctest.h>

#include <fstream>

using namespace placedpar;
using namespace placedpar::occam;

namespace {

/// Returns the printed form of a text that must be good.
std::string printed(const std::string& text) {
    const auto read = test::read_text(text);
    CHECK(read.messages == "");
    return read.parsed.program ? print(*read.parsed.program) : "";
}

/// Returns the messages about a process within a PROC.
std::string messages_of(const std::string& process) {
    std::string text = "PROC p (INT x, y, BOOL b, []INT v)\n";
    for (std::size_t start = 0; start < process.size();) {
        const auto end = std::min(process.find('\n', start), process.size());
        text += "  " + process.substr(start, end - start) + "\n";
        start = end + 1;
    }
    return test::read_text(text + ":\n").messages;
}

const Expression& value_of(const test::ReadText& read) {
    return std::get<Abbreviation>(read.parsed.program->declarations.front()->form).value;
}

} // namespace

TEST_CASE("literals have the values of their spelling") {
    const auto integer = [](const std::string& text) {
        return std::get<IntegerLiteral>(value_of(test::read_text("VAL x IS " + text + ":\n")).form);
    };
    CHECK(integer("42").value == 42);
    CHECK(!integer("42").type);
    CHECK(integer("#fF").value == 255);
    CHECK(integer("'*n'").value == 10);
    CHECK(integer("'*#0d'").value == 13);
    CHECK(integer("'*''").value == 39);
    CHECK(integer("'a'").type == Basic::byte);
    CHECK(integer("TRUE").type == Basic::boolean);
    CHECK(integer("7(INT64)").type == Basic::int64);
    CHECK(integer("7(LENGTH)").type_name == "LENGTH");
    CHECK(integer("18446744073709551615").value == 18446744073709551615u);
    const auto string = [](const std::string& text) {
        return std::get<StringLiteral>(value_of(test::read_text("VAL x IS " + text + ":\n")).form).bytes;
    };
    CHECK(string("\"a*c*n*t*s*'*\"**b\"") == "a\r\n\t '\"*b");
    CHECK(string("\"*labc\"") == "\003abc");
    CHECK(string("\"ab*\n   * cd\"") == "ab cd");
    CHECK(string("\"-- no comment\" -- a comment") == "-- no comment");
    CHECK(string("\"gr\xfc\xdf\"") == "gr\xfc\xdf");
}

TEST_CASE("an operation is at its operator and AND goes from left to right") {
    const auto read = test::read_text("VAL x IS a AND b OR (c + 1):\n");
    const auto& whole = std::get<BinaryOperation>(value_of(read).form);
    CHECK(value_of(read).at == Place{0, 1, 18});
    CHECK(whole.operation == Operator::logical_or);
    CHECK(std::get<BinaryOperation>(whole.left->form).operation == Operator::logical_and);
    CHECK(std::get<BinaryOperation>(whole.right->form).operation == Operator::add);
    CHECK(std::get<IntegerLiteral>(
              std::get<UnaryOperation>(value_of(test::read_text("VAL x IS -5:\n")).form).operand->form)
              .negative_allowed);
}

TEST_CASE("lines go on behind an operator, a comma, an opening bracket and the like") {
    const std::string expected = "PROC p (INT x, y)\n  x := y + (v[2] * f (x, y))\n:\n";
    CHECK(printed("PROC p (INT x,\n        y)\n  x :=\n    y +\n    -- a comment\n\n   (v[\n     2] * f (\n     x,\n"
                  "  y))\n:\n") == expected);
    CHECK(printed("PROC p (INT x, y)\r\n  x := y + (v[2] * f (x, y))\r\n:\r\n") == expected);
    CHECK(printed(expected + "\x1a old bytes") == expected);
}

TEST_CASE("comments have any indentation") {
    CHECK(messages_of("-- a\nSEQ\n-- b\n      -- c\n  x := 1 -- d\n--\n  y := 2") == "");
}

TEST_CASE("what INMOS's compiler accepts is accepted") {
    for (const char* process :
         {"SEQ", "IF", "b := b AND b OR b", "x := MINUS x", "x := INT \"abc\"[1]", "x := [1, 2, 3][1]",
          "x := (INT z:\n      VALOF\n        z := 1\n        RESULT z\n)", "WHILE b AND\n    b\n  SKIP",
          "IF\n  IF i = 0 FOR 3\n    b\n      SKIP\n  TRUE\n    SKIP", "INLINE PROC q ()\n  SKIP\n:\nq ()",
          "x, y := (VALOF\n           SKIP\n           RESULT 1, 2\n        )"}) {
        CAPTURE(process);
        CHECK(messages_of(process) == "");
    }
}

TEST_CASE("what INMOS's compiler refuses is refused once, at its place") {
    for (const char* process : {"x := 1 + 2 + 3", "x := - x + y", "x := x + - y", "b := NOT b AND b", "x := INT b + 1",
                                "x := SIZE v + 1", "x := INT INT b", "x := - - x", "x := (v)[0]", "INT a: INT e:\nSKIP",
                                "x := 1 y := 2", "SKIP STOP", "WHILE b\nx := 1", "ALT\n  SKIP\n    SKIP"}) {
        CAPTURE(process);
        const std::string messages = messages_of(process);
        const auto first = messages.find("error:");
        CHECK(first != std::string::npos);
        CHECK(messages.find("error:", first + 1) == std::string::npos);
    }
}

TEST_CASE("words of later versions are names where nothing else is meant") {
    CHECK(messages_of("INT STEP, DATA, RECORD, INITIAL, PACKED, TYPE:\nSEQ\n  STEP := DATA\n  SEQ i = 0 FOR STEP STEP "
                      "TYPE\n    INITIAL := i") == "");
}

TEST_CASE("the syntax of the Kent course has directions at the names of channels") {
    const std::string text =
        "PROC p (CHAN OF BYTE keyboard?, screen!)\n  here! IS screen!:\n  q (keyboard?, here!)\n:\n";
    CHECK(printed("PROC p (CHAN BYTE keyboard?, screen!)\n  here! IS screen!:\n  q (keyboard?, here!)\n:\n") == text);
    const auto read = test::read_text(text);
    const auto& parameters = std::get<Procedure>(read.parsed.program->declarations.front()->form).parameters;
    CHECK(std::get<Parameter>(parameters[0]->form).written_output == false);
    CHECK(std::get<Parameter>(parameters[1]->form).written_output == true);
}

TEST_CASE("directives choose lines and set options") {
    const std::string text = "#IF DEFINED (X) AND (NOT DEFINED (Y))\nVAL a IS 1:\n#ELIF V = 3\nVAL a IS 2:\n#ELSE\n"
                             "VAL a IS 3:\n#ENDIF\n#OPTION \"ANKUV\"\n";
    const auto of = [&](const std::string& front, const std::vector<std::string>& defined) {
        return print(*test::read_text(front + text, "text.occ", defined).parsed.program);
    };
    CHECK(of("", {}) == "VAL a IS 3:\n");
    CHECK(of("", {"X"}) == "VAL a IS 1:\n");
    CHECK(of("", {"X", "Y"}) == "VAL a IS 3:\n");
    CHECK(of("#DEFINE V 3\n", {}) == "VAL a IS 2:\n");
    CHECK(of("#DEFINE V 3\n#UNDEF V\n", {}) == "VAL a IS 3:\n");
    const auto options = test::read_text(text).parsed.options;
    CHECK(!(options.alias_checks || options.usage_checks || options.range_checks || options.run_time_checks ||
            options.vector_space));
}

TEST_CASE("files are found beside the file, and each is used once") {
    const auto folder = std::filesystem::temp_directory_path() / "placedpar-occam-files";
    std::filesystem::create_directories(folder);
    const auto write = [&](const char* name, const std::string& text) { std::ofstream(folder / name) << text; };
    const auto messages = [&](const std::string& text) {
        return test::read_text(text, (folder / "main.occ").string()).messages;
    };
    write("other.occ", "#USE \"known.lib\"\nPROC q ()\n  SKIP\n:\n");
    write("itself.inc", "#INCLUDE \"itself.inc\"\n");
    write("two.module", "#USE \"other\"\n");
    CHECK(messages("#USE \"other.tco\"\n#USE \"two.module\"\n#USE \"other.t8h\"\n") == "");
    const auto read = test::read_text("#USE \"two.module\"\n#USE \"other.tco\"\n#USE \"hostio.lib\"\n",
                                      (folder / "main.occ").string());
    REQUIRE(read.parsed.program->units.size() == 4);
    CHECK(read.parsed.program->units[0]->name == "known.lib");
    CHECK(read.parsed.program->units[1]->name == "other");
    CHECK(std::get<Use>(read.parsed.program->declarations[1]->form).unit == 1);
    write("inner.inc", "VAL z IS 1:\nSEQ\n  SKIP\n");
    CHECK(messages("PROC p ()\n  #INCLUDE \"inner.inc\"\n:\n") == "");
    CHECK(messages("#INCLUDE \"itself.inc\"\n").find("includes or uses itself") != std::string::npos);
    write("main.occ", "");
    CHECK(messages("#USE \"main.occ\"\n").find("\"main.occ\" includes or uses itself") != std::string::npos);
    for (int i = 0; i < 60; ++i)
        write(("deep" + std::to_string(i) + ".inc").c_str(), "#INCLUDE \"deep" + std::to_string(i + 1) + ".inc\"\n");
    CHECK(messages("#INCLUDE \"deep0.inc\"\n").find("at most 50 levels") != std::string::npos);
    std::filesystem::remove_all(folder);
}
