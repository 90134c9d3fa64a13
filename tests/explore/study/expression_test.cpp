// Tests expressions of a study: their names, their values, and what is refused.

#include "explore/study/expression.hpp"

#include "explore/study/figure_names.hpp"
#include "explore/study/setting_value.hpp"
#include "tests/nearly.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <set>
#include <string>

using namespace placedpar;

namespace {

double value_of(const std::string& text, const Overrides& set = {}, const StudyExpression::Figures& figures = {}) {
    return StudyExpression(text).value(set, figures);
}

} // namespace

TEST_CASE("operators have the precedence of the netlist language, which is that of C") {
    CHECK(value_of("2 + 3 * 4") == 14);
    CHECK(value_of("(2 + 3) * 4") == 20);
    CHECK(value_of("1 << 3 | 1") == 9);
    CHECK(value_of("7 / 2") == 3); // whole numbers
    CHECK(value_of("7 / 2.0") == 3.5);
    CHECK(value_of("-7 % 3") == -1);
    CHECK(value_of("3 > 2 ? 10 : 20") == 10);
}

TEST_CASE("names are settings, by their full or last name, and figures; a setting precedes a figure") {
    CHECK(value_of("n * T_exe", {{"n", "3"}}, {{"T_exe", 2.5}}) == 7.5);
    CHECK(value_of("trials", {{"master.trials", "5"}}) == 5);
    CHECK(value_of("n", {{"n", "3"}}, {{"n", 8}}) == 3);
    CHECK(value_of("n", {{"n", "1 + 2"}}) == 3);
    CHECK(value_of("trials", {{"trials", "1"}, {"master.trials", "5"}}) == 1);
}

TEST_CASE("the names in an expression are found in every part of it, also in the part that is not evaluated") {
    CHECK(StudyExpression("a + b[c] * (d ? e : -f)").names() == std::set<std::string>{"a", "b", "c", "d", "e", "f"});
    CHECK(StudyExpression("{x, y}[z] + size(list)").names().contains("z"));
    CHECK(StudyExpression("1 + 2").names().empty());
    CHECK(StudyExpression("").names().empty());
}

TEST_CASE("an empty expression always holds, and is not an expression") {
    const StudyExpression empty("");
    CHECK_FALSE(empty);
    CHECK(empty.holds({}));
    CHECK(StudyExpression("1"));
    CHECK_FALSE(StudyExpression("0").holds({}));
}

TEST_CASE("a copy has the same meaning, and evaluating leaves no names behind") {
    const StudyExpression expression("n > 1"), copy = expression;
    CHECK(copy.holds({{"n", "2"}}));
    CHECK_FALSE(expression.holds({{"n", "1"}}));
    CHECK_THROWS_AS(copy.holds({}), RefusedInput); // n of the earlier calls is forgotten
}

TEST_CASE("a suffix means millions beside a frequency only") {
    CHECK(StudyExpression("clock > 20M").holds({{"t.clock", "20000001"}}));
    CHECK_FALSE(StudyExpression("clock > 20M").holds({{"t.clock", "20000000"}}));
    CHECK_FALSE(StudyExpression("memory > 20M").holds({{"memory", "20000001"}})); // 20 Mbyte are 20971520 bytes
    CHECK(StudyExpression("linkspeed == 10M && memory == 1M").holds({{"linkspeed", "10M"}, {"memory", "1048576"}}));
}

TEST_CASE("expressions that cannot be read or computed are refused") {
    for (const char* text : {"a >", "(1", "1 1", "a b", "\"text", "{", "a ? b", "+", ";", "1;"})
        CHECK_THROWS_AS(StudyExpression{text}, RefusedInput);
    CHECK_THROWS_AS(value_of("1 / 0"), RefusedInput);
    CHECK_THROWS_AS(value_of("unknown"), RefusedInput);
    CHECK_THROWS_AS(value_of("\"text\""), RefusedInput);
    CHECK_THROWS_AS(value_of("{1, 2}[2]"), RefusedInput);
    CHECK_THROWS_AS(value_of("n + 1", {{"n", "text"}}), RefusedInput);
    CHECK_THROWS_WITH_AS(value_of("unknown"), doctest::Contains("where:1:1: error: "), RefusedInput);
}

TEST_CASE("a value of a setting is evaluated without names") {
    CHECK(number_of_setting("2 * (3 + 4)") == 14);
    CHECK(number_of_setting("5M") == 5'000'000);
    CHECK(number_of_setting("0x10") == 16);
    CHECK(number_of_setting("1e-3") == test::nearly(0.001));
    for (const char* text : {"", "n", "n + 1", "\"5\"", "{1, 2}", "5 6", "individuals", "../a.csv", "1 / 0"})
        CHECK_FALSE_MESSAGE(number_of_setting(text), text);
}

TEST_CASE("clocks and speeds of links are frequencies, with any name before the point") {
    for (const char* name : {"clock", "linkspeed", "t.clock", "t[0].x.linkspeed"})
        CHECK(is_frequency(name));
    for (const char* name : {"", "clocks", "clock.t", "memory", "Clock", "t."})
        CHECK_FALSE(is_frequency(name));
}

TEST_CASE("of two equal values the whole number is the better spelling, otherwise the first") {
    const SettingValue whole("n", "8"), real("n", "8.0"), other("n", "4 + 4");
    CHECK(better_spelt(real, whole).spelling() == "8");
    CHECK(better_spelt(whole, real).spelling() == "8");
    CHECK(better_spelt(other, whole).spelling() == "4 + 4");
    CHECK(real.is_real());
    CHECK_FALSE(other.is_real());
}

TEST_CASE("a name must have one meaning; a setting has one also by its last name") {
    FigureNames names, rows;
    names.add_settings({{"master.trials", "5"}, {"slaves", "2"}});
    names.add_measures({"max(m.T_exe)"});
    rows.add("speedup", "the row above");
    CHECK_NOTHROW(names.require(StudyExpression("T_exe / trials * slaves + speedup"), rows));
    CHECK_THROWS_WITH_AS(names.require(StudyExpression("speedup"), {}),
                         "the name \"speedup\" is undefined; the defined names are T_exe, slaves, trials", UserError);
    CHECK_THROWS_WITH_AS(names.require(StudyExpression("slavs"), {}),
                         doctest::Contains("the name \"slavs\" is undefined; did you mean \"slaves\"?"), UserError);
    CHECK_THROWS_WITH_AS(FigureNames().require(StudyExpression("n"), {}),
                         "the name \"n\" is undefined; no name is defined here", UserError);
    rows.add("slaves", "the row above");
    CHECK_THROWS_WITH_AS(names.require(StudyExpression("slaves"), rows),
                         "\"slaves\" is ambiguous: it stands for the row above and for the setting slaves", UserError);
}

TEST_CASE("two settings with one last name make this name ambiguous, unless a setting has it itself") {
    FigureNames names, plain;
    names.add_settings({{"a.n", "1"}, {"b.n", "2"}});
    CHECK_THROWS_WITH_AS(names.require(StudyExpression("n"), {}),
                         "\"n\" is ambiguous: it stands for the setting a.n and for the setting b.n", UserError);
    plain.add_settings({{"a.n", "1"}, {"n", "2"}});
    CHECK_NOTHROW(plain.require(StudyExpression("n"), {}));
}
