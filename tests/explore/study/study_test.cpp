#include "explore/study/measure.hpp"
#include "explore/study/study.hpp"
#include "explore/study/study_file.hpp"
#include "explore/study/study_settings.hpp"
#include "explore/study/summary.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

using namespace placedpar;

namespace {

std::vector<std::string> all_values(const std::string& text) {
    StudyAxis axis = read_axis("x=" + text);
    std::vector<std::string> values;
    for (std::uint64_t i = 0; i < axis.count(); ++i)
        values.push_back(axis.at(i));
    return values;
}

using Values = std::vector<std::string>;

Study two_axes(const std::string& where) {
    Study study;
    study.products.push_back({.axes = {read_axis("a=0..2"), read_axis("b.c=5M,7M")}, .where = StudyExpression(where)});
    study.seeds = 2;
    return study;
}

std::size_t count_runs(const Study& study) {
    std::size_t count = 0;
    for (std::uint64_t i = 0; i < study.count(); ++i)
        count += study.at(i).has_value() ? 1 : 0;
    return count;
}

} // namespace

TEST_CASE("values are lists and ranges") {
    CHECK(all_values("3") == Values{"3"});
    CHECK(all_values("0..3") == Values{"0", "1", "2", "3"});
    CHECK(all_values("-1..1") == Values{"-1", "0", "1"});
    CHECK(all_values("0..7..3") == Values{"0", "3", "6"});
    CHECK(all_values("1..64..x4") == Values{"1", "4", "16", "64"});
    CHECK(all_values("0.1..0.3..0.1") == Values{"0.1", "0.2", "0.3"});
    CHECK(all_values("5M..20M..5M") == Values{"5000000", "10000000", "15000000", "20000000"});
    CHECK(all_values("8, 0..1,\"a,b\",size({1,2})") == Values{"8", "0", "1", "\"a,b\"", "size({1,2})"});
    CHECK(all_values("individuals,../records/boom.csv") == Values{"individuals", "../records/boom.csv"});
    CHECK(read_axis("x=0..999999999999").count() == 1'000'000'000'000);
}

TEST_CASE("values that mean the same are equal, however they are spelled") {
    auto equal = [](const std::string& name, const std::string& a, const std::string& b) {
        return SettingValue(name, a) == SettingValue(name, b);
    };
    for (const char* name : {"clock", "t.clock", "t[0].linkspeed"}) {
        CHECK(equal(name, "20M", "20000000"));
        CHECK(equal(name, "20M", "20000k"));
        CHECK_FALSE(equal(name, "20M", "20971520"));
    }
    CHECK_FALSE(equal("memory", "1M", "1000000")); // a size, so M is 1048576
    CHECK_FALSE(equal("memory", "1M", "1000K"));
    CHECK(equal("memory", "1M", "1m"));
    CHECK(equal("slaves", "8", "8.0"));
    CHECK(equal("slaves", "8", "4+4"));
    CHECK(equal("mutation", "0.50", "5e-1"));
    CHECK_FALSE(equal("seed", "9007199254740993", "9007199254740992")); // as doubles they would be equal
    CHECK(equal("topology", "ring", "\"ring\""));
    CHECK_FALSE(equal("topology", "ring", "rings"));
    CHECK_FALSE(equal("name", "8", "\"8\""));
    CHECK(equal("place", "{1,2}", "{1,2}"));
}

TEST_CASE("a condition holds for equal values, however they are spelled") {
    StudyExpression speed("linkspeed == 20M"), plain("2 * linkspeed > 39999999 && memory == 1M");
    for (const char* value : {"20M", "20000000", "20000k", "20e6"})
        CHECK(speed.holds({{"linkspeed", value}}));
    CHECK(speed.holds({{"t.linkspeed", "20M"}}));
    CHECK_FALSE(speed.holds({{"linkspeed", "20971520"}}));
    CHECK(plain.holds({{"linkspeed", "20M"}, {"memory", "1048576"}}));
    CHECK_FALSE(plain.holds({{"linkspeed", "20M"}, {"memory", "1000000"}}));
    CHECK_FALSE(plain.holds({{"linkspeed", "19M"}, {"memory", "1M"}}));
    CHECK(StudyExpression("slaves == 8").holds({{"slaves", "8.0"}}));
}

TEST_CASE("equal values count once, spelled as the first value or as a whole number") {
    CHECK(all_values("20000k,7,20000k,07") == Values{"20000k", "7"});
    CHECK(all_values("a,\"a\",b") == Values{"a", "b"});
    CHECK(all_values("8.0,8,0.5,.5") == Values{"8", "0.5"});
    CHECK(all_values("0..3,2.0,4") == Values{"0", "1", "2", "3", "4"});
    StudyAxis speeds = read_axis("linkspeed=20M,5M,20000000");
    CHECK(speeds.count() == 2);
    CHECK(speeds.at(0) == "20M");
    Study study;
    study.products.push_back({.axes = {speeds, read_axis("slaves=1.0,3")}});
    study.products.push_back({.axes = {read_axis("slaves=0..8")}});
    CHECK(study.has_some({{"linkspeed", "5000000"}, {"slaves", "3.0"}}));
    CHECK(study.find("slaves", {"slaves", "1.0"})->spelling() == "1");
    CHECK(study.find("linkspeed", {"linkspeed", "5000k"})->spelling() == "5M");
    CHECK_FALSE(study.find("linkspeed", {"linkspeed", "6M"}));
}

TEST_CASE("empty and too large ranges are refused") {
    for (const char* text : {"x=1..0", "x=0..4..0", "x=0..4..-1", "x=0..4..x2", "x=1..4..x1", "x=0..y", "x=0..1e300",
                             "x=", "x=1,", "=1", "x"})
        CHECK_THROWS_AS(read_axis(text), UserError);
}

TEST_CASE("a study consists of all combinations that meet its condition, with each seed") {
    CHECK(count_runs(two_axes("")) == 12);
    CHECK(count_runs(two_axes("a > 0")) == 8);
    CHECK(count_runs(two_axes("a == 1 && c == 7M")) == 2);
    Study study = two_axes("");
    study.first_seed = 7;
    CHECK(study.at(3) == StudyRun{{{"a", "0"}, {"b.c", "7M"}}, 8});
    CHECK_THROWS_WITH_AS(two_axes("d > 0").at(0), doctest::Contains("the name \"d\" is undefined"), RefusedInput);
    CHECK_THROWS_AS(StudyExpression("a >"), RefusedInput);
}

TEST_CASE("a study finds any combination without enumerating earlier combinations") {
    Study study = two_axes("a > 0");
    study.products.push_back({.axes = {read_axis("far=0..999999999999..3,x,0.1..0.3..0.1,1..64..x2")}});
    study.products.push_back({.axes = {read_axis("a=7.0"), read_axis("only=x")}});
    const StudySettings settings(study.products);
    for (std::uint64_t i = 0; i < 12; ++i)
        if (std::optional<StudyRun> run = study.at(i))
            CHECK(settings.has(run->set));
    for (const char* range :
         {"x=1000000000006..1000000000008..0.5", "x=1..2..x1.0000001", "x=-3..3..0.7", "x=5M..20M..5M"}) {
        Study rounded;
        rounded.products.push_back({.axes = {read_axis(range)}});
        for (std::uint64_t i = 0; i < std::min<std::uint64_t>(rounded.count(), 1000); ++i)
            CHECK(StudySettings(rounded.products).has(rounded.at(i)->set));
    }
    CHECK(settings.has({{"a", "1"}, {"b.c", "5M"}}));
    CHECK_FALSE(settings.has({{"a", "0"}, {"b.c", "5M"}})); // the condition
    CHECK_FALSE(settings.has({{"a", "3"}, {"b.c", "5M"}}));
    CHECK(settings.has({{"a", "1.0"}, {"b.c", "5M"}}));
    CHECK_FALSE(settings.has({{"a", "1"}, {"b.c", "5000000"}})); // 5M may be a size, 5242880
    CHECK_FALSE(settings.has({{"a", "1"}}));
    CHECK_FALSE(settings.has({{"a", "1"}, {"b.c", "5M"}, {"d", "1"}}));
    CHECK(settings.has({{"a", "7"}, {"only", "\"x\""}}));
    CHECK_FALSE(settings.has({{"a", "8"}, {"only", "x"}}));
    CHECK_FALSE(settings.has({{"a", "7"}}));
    for (const char* value : {"0", "3", "999999999999", "x", "0.1", "0.2", "0.3", "1", "2", "64"})
        CHECK(settings.has({{"far", value}}));
    for (const char* value : {"-3", "5", "1000000000002", "y", "0.4", "0.15", "128", ""})
        CHECK_FALSE(settings.has({{"far", value}}));
}

TEST_CASE("a study whose number of runs exceeds 64 bits is refused with its largest settings") {
    Study study;
    study.products.push_back({{read_axis("a=0..65535"), read_axis("b=1..65536"), read_axis("once=1"),
                               read_axis("c=1..65536"), read_axis("d=1..65535,0")}}); // 2^64 runs, which is 0 in 64
                                                                                      // bits
    CHECK_THROWS_WITH_AS(study.products[0].count(),
                         doctest::Contains("4 settings with several values (65536 of a, 65536 of b, 65536 of c, 65536 "
                                           "of d), each run with 1 seed, are more than 18446744073709551615"),
                         UserError);
    CHECK_THROWS_AS(study.count(), UserError);
    study.products[0].axes.pop_back(); // now 2^48 runs
    study.seeds = 65535;
    CHECK(study.count() == 65535ULL << 48);
    study.products.push_back({{read_axis("a=1..65536"), read_axis("b=1..4294967296")}});
    study.seeds = 65536;
    CHECK_THROWS_WITH_AS(study.count(), doctest::Contains("each run with 65536 seeds, are more than"), UserError);
    study.seeds = 32768;
    CHECK_THROWS_WITH_AS(study.count(), doctest::Contains("the 2 products of [set] and [[also]] together"), UserError);
}

TEST_CASE("values and seeds whose number exceeds 64 bits are refused") {
    StudyAxis axis{"a", std::vector<StudyValues>(18'447, StudyValues("a", "1..1000000000000000"))};
    CHECK_THROWS_WITH_AS(axis.count(), doctest::Contains("a: the 18447 ranges and values have too many values"),
                         UserError);
    axis.parts.pop_back();
    CHECK(axis.count() == 18'446'000'000'000'000'000U);
    constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
    Study study;
    study.products.emplace_back();
    study.seeds = most;
    CHECK(study.count() == most);
    study.first_seed = 2;
    CHECK_THROWS_WITH_AS(study.count(),
                         doctest::Contains("seeds from 2 on are too many: the greatest seed is 18446744073709551615"),
                         UserError);
}

TEST_CASE("a measure is one figure or an aggregate of several") {
    StudyFigures figures{{"time", {2, "ms"}}, {"m[0].T", {1, "ms"}}, {"m[1].T", {4, "ms"}}, {"n.T", {9, ""}}};
    auto value = [&](const char* text) { return StudyMeasure(text).of(figures).value().value; };
    CHECK(value("time") == 2);
    CHECK(value("m[1].T") == 4);
    CHECK(value("m.T") == 2.5);
    CHECK(value("min(m.T)") == 1);
    CHECK(value("max(m.T)") == 4);
    CHECK(value("sum(m.T)") == 5);
    CHECK(value("n.T") == 9);
    CHECK_FALSE(StudyMeasure("m.X").of(figures));
    CHECK(StudyMeasure("m.T").of(figures)->unit == "ms");
    CHECK_THROWS_AS(StudyMeasure("max(m.T"), UserError);
}

TEST_CASE("figures are read back without loss") {
    StudyFigures figures{{"a[0].\"b\\", {3999.2662143707275, "a \"unit\""}},
                         {"c", {-1e-300, ""}},
                         {"d", {20, "%"}},
                         {"e", {0.1 + 0.2, "1/s"}}};
    StudyFigures again = figures_from(figures_text(figures));
    REQUIRE(again.size() == figures.size());
    for (const auto& [name, figure] : figures) {
        CHECK(again.at(name).value == figure.value);
        CHECK(again.at(name).unit == figure.unit);
    }
}

TEST_CASE("a cell's interval is Student's confidence interval") {
    StudyCell cell;
    for (double value : {4.0, 6.0, 8.0})
        cell.add(value);
    cell.close();
    CHECK(cell.mean == doctest::Approx(6));
    CHECK(cell.half_width == doctest::Approx(4.302652729911275 * 2 / 1.7320508075688772));
    CHECK(cell.least == 4);
    CHECK(cell.greatest == 8);
    StudyCell single;
    single.add(1);
    single.close();
    CHECK(single.half_width == 0);
}

TEST_CASE("a study whose headers violate an assertion of the TOML parser is refused in every build") {
    const auto path = std::filesystem::temp_directory_path() / "placedpar_study_test.toml";
    for (const char* text : {"[(set]\n", "[[(]]\n", "[set\n", "(a = 1\n", "a = (1\n", "x.( = 1\n", "a = {( = 1}\n"}) {
        INFO(text);
        std::ofstream(path) << text;
        CHECK_THROWS_AS(read_study(path.string()), RefusedInput);
    }
    std::filesystem::remove(path);
}
