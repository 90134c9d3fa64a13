// Tests a row that is described once and printed as text, JSON and CSV.

#include "report/field.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <string>
#include <vector>

using namespace placedpar;

namespace {

struct Fruit {
    std::string name;
    int count;
    double weight;
    std::optional<Time> picked = {};
};

Row row_of(const Fruit& fruit) {
    return {Field::left(0, "fruit", fruit.name).as("name"), Field::count(6, "count", fruit.count),
            Field::right(8, "grams", fmt::format("{:.1f}", fruit.weight)).as("weight_g", fruit.weight),
            Field::member_ps("picked", fruit.picked)};
}

Table basket() {
    return table_of(std::vector<Fruit>{{"apple", 12, 150.25, Time{7}}, {"pomegranate", 3, 282, {}}}, row_of);
}

} // namespace

TEST_CASE("a printed table has headings and columns of the needed or stated width") {
    CHECK(basket().text() == "fruit         count     grams\n"
                             "apple            12     150.2\n"
                             "pomegranate       3     282.0\n");
    CHECK(basket().text("\nin the basket\n").starts_with("\nin the basket\nfruit "));
}

TEST_CASE("a text longer than its column overflows it") {
    Row row = row_of({"fig", 12345678, 1});
    CHECK(Table{row, {row}}.text() == "fruit   count     grams\n"
                                      "fig    12345678       1.0\n");
}

TEST_CASE("a table without rows has its headings") {
    CHECK(table_of(std::vector<Fruit>{}, row_of).text() == "fruit   count     grams\n");
    CHECK(table_of(std::vector<Fruit>{}, row_of).csv() == "name,count,weight_g\n");
}

TEST_CASE("no line ends in blanks") {
    Row row{Field::left(9, "a", "1"), Field::left(9, "b", "")};
    CHECK(Table{row, {row}}.text() == "a          b\n1\n");
}

TEST_CASE("an optional column is printed only on request, but documents always have it") {
    auto row = [](bool shown) -> Row { return {Field::left(0, "a", "1"), Field::count(3, "b", 2).shown_if(shown)}; };
    CHECK(Table{row(true), {row(true)}}.text() == "a    b\n1    2\n");
    CHECK(Table{row(false), {row(false)}}.text() == "a\n1\n");
    CHECK(json_of(row(false)) == boost::json::object{{"b", 2}});
}

TEST_CASE("a document has the fields with keys, in order, with exact values") {
    CHECK(serialize(json_of(basket().rows)) == R"([{"name":"apple","count":12,"weight_g":1.5025E2,"picked_ps":7},)"
                                               R"({"name":"pomegranate","count":3,"weight_g":2.82E2}])");
    CHECK(serialize(json_of(Row{Field::member("only here", true)})) == R"({"only here":true})");
}

TEST_CASE("comma-separated values are quoted if necessary, and empty if missing") {
    auto row = [](const std::string& text, const boost::json::value& value) -> Row {
        return {Field::left(0, "a", text).as("a"), Field::member("b, c", value)};
    };
    Table table{row("", nullptr), {row("plain", 0.1), row("one, two", nullptr), row("\"so\"", 3)}};
    CHECK(table.csv() == "a,\"b, c\"\n"
                         "plain,0.1\n"
                         "\"one, two\",\n"
                         "\"\"\"so\"\"\",3\n");
}
