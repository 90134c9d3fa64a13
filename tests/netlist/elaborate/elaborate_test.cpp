// Tests expressions, names and vals.

#include "tests/netlist/good_networks.hpp"

#include <doctest/doctest.h>

#include <limits>

using namespace placedpar;

namespace {

/// Returns the value of an expression that is assigned to a parameter.
std::int64_t integer(const std::string& expression) {
    auto network = good_text("val a {1, 2, {3}[0]}; val table {{1, 2, 3}, {4, 5, 6}};\n"
                             "T800 t; process (interface (long n)) p; place p on t; use \"p.lku\" for p; p (n = " +
                             expression + ");");
    return std::get<std::int64_t>(network.processes[0].parameters.at("n"));
}

/// Returns how many nodes a replicator declares.
std::size_t rounds(const std::string& replicator) {
    return good_text("rep i = " + replicator + " edge e;").nodes.size();
}

} // namespace

TEST_CASE("a val is overridden from outside") {
    CHECK(good("cluster_of_n.cfs").nodes.size() == 4);
    auto alone = good("cluster_of_n.cfs", {{"slaves", "0"}});
    CHECK(alone.nodes.size() == 1);
    CHECK(channel(alone, "m.out -> s.in").placement.kind == ChannelPlacement::Kind::soft);
    CHECK(good("cluster_of_n.cfs", {{"slaves", "2 * 2 + 1"}}).nodes.size() == 6);
    // Later vals and frequencies use the overridden value.
    CHECK(good_text("val a 1; val b a + 1; edge t[b];", {{"a", "4"}}).nodes.size() == 5);
    CHECK(good_text("val f 20M; T800 (clock = f) t;", {{"f", "25M"}}).nodes[0].integer("clock") == 25'000'000);
}

TEST_CASE("M means a million in a frequency and 1048576 elsewhere") {
    auto network = good_text("val m 2M; T800 (memory = m, clock = 17500k, linkspeed = m * 10) t;");
    CHECK(network.nodes[0].integer("memory") == 2 * 1024 * 1024);
    CHECK(network.nodes[0].integer("clock") == 17'500'000);
    CHECK(network.nodes[0].integer("linkspeed") == 20'000'000);
}

TEST_CASE("a name is valid to the end of its block") {
    auto network =
        good_text("T800 t; rep i = 0 for 3 { val t_of_i i * 10; process (interface (int n)) p; p (n = t_of_i);"
                  "place p on t; use \"p.lku\" for p; } process p; use \"p.lku\" for p; place p on t;");
    REQUIRE(network.processes.size() == 4);
    CHECK(network.processes[0].name == "p");
    CHECK(network.processes[2].name == "p_3");
    CHECK(network.processes[2].parameters.at("n") == Value(std::int64_t{20}));
    CHECK(network.processes[3].name == "p_4");
    // A statement after `if` without braces belongs to the enclosing block.
    CHECK(good_text("val one 1; if one == 1 T800 t; else T414 t; process p; place p on t;").nodes[0].type == "T800");
}

TEST_CASE("expressions have the values of C") {
    CHECK(integer("2 + 3 * 4") == 14);
    CHECK(integer("(2 + 3) * 4") == 20);
    CHECK(integer("10 - 4 - 3") == 3);
    CHECK(integer("-7 / 2") == -3);
    CHECK(integer("-7 % 2") == -1);
    CHECK(integer("1 < 2 == TRUE && !0") == 1);
    CHECK(integer("0 && 1 / 0") == 0); // the right side is not evaluated
    CHECK(integer("1 || 1 / 0") == 1);
    CHECK(integer("0x1F") == 31);
    CHECK(integer("2k") == 2048);
    CHECK(integer("'a'") == 97);
    CHECK(integer("'\\n' + '\\x41' + '\\101'") == 10 + 65 + 65);
    CHECK(integer("(char) 42") == 42);
    CHECK(integer("(int) 2.9 + (int) 2.5f") == 4);
    CHECK(integer("a[0] + a[2]") == 4);
    CHECK(integer("\"abc\"[1]") == 98);
    CHECK(integer("\"abc\" == \"abc\"") == 1);
    CHECK(integer("1.5 > 1") == 1);
    CHECK(integer("9223372036854775807") == std::numeric_limits<std::int64_t>::max());
}

TEST_CASE("HIGH is 0 and LOW is 1") {
    CHECK(integer("HIGH") == 0);
    CHECK(integer("high") == 0);
    CHECK(integer("LOW") == 1);
    CHECK(integer("low") == 1);
    CHECK(integer("TRUE") == 1);
    CHECK(integer("false") == 0);
    auto is_high = [](const std::string& priority) {
        return good_text("T800 t; process (priority = " + priority + ") p; place p on t;").processes[0].high_priority;
    };
    CHECK(is_high("HIGH"));
    CHECK(is_high("0"));
    CHECK_FALSE(is_high("LOW"));
    CHECK_FALSE(is_high("1"));
}

TEST_CASE("a leading 0 makes a number octal") {
    CHECK(integer("010") == 8);
    CHECK(integer("0777 + 00") == 511);
    CHECK(integer("010k") == 8192);
    CHECK(integer("0") == 0);
    CHECK(integer("10") == 10);
    CHECK(integer("(int) 010.5") == 10); // real numbers are decimal
    CHECK(integer("(int) 019f") == 19);
    CHECK(integer("0777777777777777777777") == std::numeric_limits<std::int64_t>::max());
}

TEST_CASE("bit operators have the precedence of C") {
    CHECK(integer("~0") == -1);
    CHECK(integer("~5 & 0xFF") == 250);
    CHECK(integer("6 & 3 | 8 ^ 12") == ((6 & 3) | (8 ^ 12)));
    CHECK(integer("1 | 6 ^ 3 & 2") == (1 | (6 ^ (3 & 2))));
    CHECK(integer("1 & 3 == 3") == 1); // `==` binds more strongly than `&`
    CHECK(integer("1 << 2 + 3") == 32);
    CHECK(integer("1 << 4 >> 2") == 4);
    CHECK(integer("2 < 1 << 1 + 1") == 1);
    CHECK(integer("0 && 1 | 1") == 0);
    CHECK(integer("-8 >> 1") == -4);
    CHECK(integer("1 << 62") == std::int64_t{1} << 62);
    CHECK(good_text("T800 (clock = 5M << 2) t;").nodes[0].integer("clock") == 20'000'000);
}

TEST_CASE("a conditional expression evaluates only one branch") {
    CHECK(integer("1 ? 2 : 3") == 2);
    CHECK(integer("0 ? 1 / 0 : 3") == 3);
    CHECK(integer("0 ? 1 : 0 ? 2 : 3") == 3);
    CHECK(integer("1 ? 0 ? 5 : 6 : 7") == 6);
    CHECK(integer("1 || 0 ? 8 : 9") == 8);
    CHECK(integer("(2 > 1 ? {7, 8} : {9, 9})[1]") == 8);
    CHECK(integer("10 + (1 ? 1 : 2)") == 11);
}

TEST_CASE("size counts the elements of arrays and the characters of strings") {
    CHECK(integer("size(a)") == 3);
    CHECK(integer("size(table) * 10 + size(table[1])") == 23);
    CHECK(integer("size(\"four\")") == 4);
    // `size` is still allowed as a name.
    CHECK(good_text("val size 2; T800 t[size]; connect t[0].link[0] to t[1].link[0];").nodes.size() == 2);
}

TEST_CASE("rep has a count or a last value") {
    CHECK(rounds("2 for 3") == 3);
    CHECK(rounds("2 to 3") == 2);
    CHECK(rounds("0 to 0") == 1);
    CHECK(rounds("0 to -1") == 0);
    CHECK(rounds("5 to 3") == 0);
}
