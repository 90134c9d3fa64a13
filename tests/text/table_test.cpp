#include "text/table.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace placedpar;

namespace {

std::string only_fault(std::string_view text) {
    std::vector<Diagnostic> faults;
    split_table(text, faults);
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].severity == Severity::error);
    return std::to_string(faults[0].location.line) + ":" + std::to_string(faults[0].location.column) + ": " +
           faults[0].message;
}

double number(std::string text, std::string* message = nullptr) {
    std::vector<Diagnostic> faults;
    double value = number_in({std::move(text), 7}, 3, faults);
    if (message) {
        REQUIRE(faults.size() == 1);
        CHECK(faults[0].location.line == 3);
        CHECK(faults[0].location.column == 7);
        *message = faults[0].message;
    } else {
        CHECK(faults.empty());
    }
    return value;
}

} // namespace

TEST_CASE("a table has cells with places, comments and a description") {
    std::vector<Diagnostic> faults;
    TextTable table =
        split_table("# one\n#two \n\n a , b\t,c\n# not a description\n1, 2 ,\"x, \"\"y\"\"\"\n\n4,,6", faults);
    CHECK(faults.empty());
    CHECK(table.description == "one\ntwo\n");
    REQUIRE(table.header.cells.size() == 3);
    CHECK(table.header.line == 4);
    CHECK(table.header.cells[1].text == "b");
    CHECK(table.header.cells[1].column == 6);
    REQUIRE(table.rows.size() == 2);
    CHECK(table.rows[0].line == 6);
    CHECK(table.rows[0].cells[2].text == "x, \"y\"");
    CHECK(table.rows[0].cells[2].column == 8);
    CHECK(table.rows[1].line == 8);
    CHECK(table.rows[1].cells[1].text.empty());
}

TEST_CASE("CR LF, a byte order mark, and a missing last line end are accepted") {
    std::vector<Diagnostic> faults;
    TextTable table = split_table("\xef\xbb\xbf# d\r\na,b\r\n1,2\r\n3,4", faults);
    CHECK(faults.empty());
    CHECK(table.description == "d\n");
    REQUIRE(table.rows.size() == 2);
    CHECK(table.rows[0].cells[1].text == "2");
}

TEST_CASE("a table may have another separator, a separator at the end of its rows, and decimal commas") {
    std::vector<Diagnostic> faults;
    TextTable table;
    table.separator = ';';
    append_lines(table, "a;b\n1,5;\"x;y\";\n#N/A;2\n# comment\n#NVM 3;4\n#N/A of 5;6\n", 1, faults);
    CHECK(faults.empty());
    REQUIRE(table.rows.size() == 2);
    CHECK(table.rows[0].cells[1].text == "x;y");
    CHECK(table.rows[1].cells[0].text == "#N/A");
    CHECK(number_in(table.rows[0].cells[0], 2, faults, ',') == 1.5);
    CHECK(faults.empty());
    CHECK(number_in({"1.5", 1}, 2, faults, ',') == 0);
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].hint.find("decimal commas") != std::string::npos);
}

TEST_CASE("a row whose first cell is a spreadsheet's error is not a comment") {
    for (const char* word : {"#VALUE!", "#REF!", "#DIV/0!", "#NAME?", "#WERT!", "#BEZUG!", "#NV", "#N/A"}) {
        std::vector<Diagnostic> faults;
        const TextTable table = split_table(std::string("a,b\n") + word + ",2\n# " + word + ",2\n", faults);
        REQUIRE(table.rows.size() == 1);
        CHECK(table.rows[0].cells[0].text == word);
    }
}

TEST_CASE("an empty text is an empty table") {
    std::vector<Diagnostic> faults;
    for (const char* text : {"", "\n\n", "# only this\n", "\xef\xbb\xbf", "\r\n"}) {
        TextTable table = split_table(text, faults);
        CHECK(table.header.cells.empty());
        CHECK(table.rows.empty());
    }
    CHECK(faults.empty());
}

TEST_CASE("a wrong row is reported") {
    CHECK(only_fault("a,b\n1,2\n1,2,3\n") == "3:5: the row has the wrong number of values: 3, expected 2");
    CHECK(only_fault("a,b\n1\n") == "2:1: the row has the wrong number of values: 1, expected 2");
    CHECK(only_fault("a,b\n1,\"2\n3,4\n") == "2:3: a quoted value has no closing quote");
    CHECK(only_fault("a,b\r1,2\r") == "1:4: the line has a carriage return before its end");
    CHECK(only_fault("time [s];boom.spool [in]\n0,1;0,2\n") == "1:9: the columns are separated by semicolons");
    CHECK(only_fault("time\tspool\n0\t1\n") == "1:5: the columns are separated by tabs");
}

TEST_CASE("cells are read as numbers") {
    CHECK(number("1830.5") == 1830.5);
    CHECK(number("-2e-3") == -2e-3);
    CHECK(number("+4") == 4);
    for (const char* wrong :
         {"nan", "NaN", "inf", "-inf", "1.5 psi", "1,5", "--2", "+-2", "++2", "1e", "abc", "1 2", "0x10"}) {
        std::string message;
        number(wrong, &message);
        CHECK(message == "\"" + std::string(wrong) + "\" is not a finite number");
    }
    std::string message;
    number("", &message);
    CHECK(message == "the value is missing");
    number("1e999", &message);
    CHECK(message == "\"1e999\" is beyond the range of numbers");
    CHECK(number("-1e-999") == 0); // too near to 0 for a double
}
