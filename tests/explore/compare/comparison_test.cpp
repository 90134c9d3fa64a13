// Tests the comparison of two runs: their differences, and the time that each difference takes.

#include "explore/compare/comparison.hpp"

#include "netlist/network/network.hpp"
#include "tests/nearly.hpp"
#include "tests/scratch.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

using namespace placedpar;
using Section = StructureDifference::Section;

namespace {

/// A computes for 1000000 cycles, which take 50 ms at 20 MHz, and then sends 40000 bytes.
const std::string two_transputers = R"(
val cycles 1000000;
T800 (clock = 20M, linkspeed = 20M) a, b;
process source, sink;
use "csp.producer" for source;
use "csp.consumer" for sink;
source (count = 1, cycles = cycles, bytes = 40000);
sink (count = 1);
place source on a;
place sink on b;
connect source.out to sink.in;
connect a.link[0] to b.link[0];
)";

std::string replaced(std::string text, const std::string& old, const std::string& with) {
    const std::size_t at = text.find(old);
    REQUIRE(at != std::string::npos);
    return text.replace(at, old.size(), with);
}

/// Netlists in files, since a comparison reads the constants in the files.
class ComparedFiles {
public:
    explicit ComparedFiles(const std::string& text_a = two_transputers, const std::string& text_b = two_transputers)
        : a(run_of("a.cfs", text_a)), b(run_of("b.cfs", text_b)) {}

    NetlistComparison compared() const {
        return compare_runs(a, b, Interruption{}, [](std::size_t, std::size_t) {});
    }

private:
    ComparedRun run_of(const std::string& name, const std::string& text) const {
        return {.name = name, .parsed = ParsedNetlist(folder_.write(name, text))};
    }

    Scratch folder_;

public:
    ComparedRun a, b;
};

/// Returns the milliseconds by which the change lengthens run A.
double effect_ms(const NetlistComparison& compared, const OneChange& change) {
    REQUIRE(change.completed());
    return in_milliseconds(change.time - compared.report_a.result.time);
}

bool has_text(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

} // namespace

TEST_CASE("equal netlists have no difference, and no change is tried") {
    const NetlistComparison compared = ComparedFiles().compared();
    CHECK(compared.both_completed());
    CHECK(compared.settings.empty());
    CHECK(compared.structure.empty());
    CHECK(compared.alone.empty());
    CHECK_FALSE(compared.together);
    CHECK(compared.difference() == Time{0});
    const std::string text = print_compared(compared);
    CHECK(has_text(text, "A  a.cfs: completed at "));
    CHECK(has_text(text, "what differs\n  nothing in the netlists\n"));
    CHECK(has_text(text, "All measures of both runs are equal.\n"));
}

TEST_CASE("half the clock adds the time of the computation, half the speed of the link that of the message") {
    const ComparedFiles files(
        two_transputers, replaced(two_transputers, "clock = 20M, linkspeed = 20M", "clock = 10M, linkspeed = 10M"));
    const NetlistComparison compared = files.compared();
    REQUIRE(compared.settings.size() == 2);
    CHECK(compared.settings[0].name == "clock");
    CHECK(compared.settings[0].a == "20000000");
    CHECK(compared.settings[0].b == "10000000");
    CHECK(compared.settings[0].elements == std::vector<std::string>{"a", "b"});
    CHECK(compared.settings[0].set == Overrides{{"a.clock", "10000000"}, {"b.clock", "10000000"}});
    REQUIRE(compared.alone.size() == 2);
    CHECK(effect_ms(compared, compared.alone[0]) == test::nearly(50, .01));
    const double message_ms = 40000 * 11 / 20e6 * 1000; // 11 bits a byte: a start bit, a one, 8 bits of data, a zero
    CHECK(effect_ms(compared, compared.alone[1]) == test::nearly(message_ms, .2));
    REQUIRE(compared.together);
    CHECK(compared.together->time == compared.report_b.result.time);
    CHECK(has_text(print_compared(compared), "The differences add up: none changes the effect of another.\n"));
}

TEST_CASE("a constant differs as a constant; the parameters that it determines are no further difference") {
    const ComparedFiles files(two_transputers, replaced(two_transputers, "val cycles 1000000", "val cycles 3000000"));
    const NetlistComparison compared = files.compared();
    REQUIRE(compared.settings.size() == 1);
    CHECK(compared.settings[0].name == "cycles");
    CHECK(compared.settings[0].elements.empty());
    CHECK(compared.settings[0].set == Overrides{{"cycles", "3000000"}});
    REQUIRE(compared.alone.size() == 1);
    CHECK(compared.alone[0].what == "cycles: 1000000 in A, 3000000 in B");
    CHECK(effect_ms(compared, compared.alone[0]) == test::nearly(100, .01));
    CHECK(compared.alone[0].time == compared.report_b.result.time);
}

TEST_CASE("settings by option count like settings in the file") {
    ComparedFiles files;
    files.b.set = {{"cycles", "2000000"}, {"source.bytes", "20000"}};
    const NetlistComparison compared = files.compared();
    REQUIRE(compared.settings.size() == 2);
    CHECK(compared.settings[0].b == "2000000");
    CHECK(compared.settings[1].name == "bytes");
    CHECK(compared.settings[1].elements == std::vector<std::string>{"source"});
    CHECK(compared.together->time == compared.report_b.result.time);
}

TEST_CASE("a part that only B has is a difference of the structure") {
    const ComparedFiles files(two_transputers,
                              replaced(two_transputers, "a, b;", "a, b, c;") + "connect b.link[1] to c.link[2];\n");
    const NetlistComparison compared = files.compared();
    REQUIRE(compared.structure.size() == 1);
    CHECK(compared.structure[0].section == Section::hardware);
    CHECK(compared.structure[0].only_a.empty());
    CHECK(compared.structure[0].only_b == std::vector<std::string>{"T800 c", "b.link[1] to c.link[2]"});
    REQUIRE(compared.alone.size() == 1);
    CHECK(compared.alone[0].what == "the hardware of B");
    CHECK(effect_ms(compared, compared.alone[0]) == 0);
    CHECK(has_text(print_compared(compared), "  hardware: 2 only in B: T800 c, b.link[1] to c.link[2]\n"));
}

TEST_CASE("the placement is a difference of its own: on one processor the message needs no link") {
    const ComparedFiles files(two_transputers, replaced(two_transputers, "place sink on b", "place sink on a"));
    const NetlistComparison compared = files.compared();
    REQUIRE(compared.structure.size() == 1);
    CHECK(compared.structure[0].section == Section::mapping);
    REQUIRE(compared.alone.size() == 1);
    CHECK(compared.alone[0].time == compared.report_b.result.time);
    CHECK(effect_ms(compared, compared.alone[0]) < -20); // the message took 22 ms or more
}

TEST_CASE("structure that follows from a constant is not tried alone") {
    const std::string many = two_transputers + "val extra 0;\nif extra > 0 {\n    T800 c[extra];\n"
                                               "    rep i = 0 for extra\n        connect b.link[i + 1] to "
                                               "c[i].link[0];\n}\n";
    const ComparedFiles files(many, replaced(many, "val extra 0", "val extra 2"));
    const NetlistComparison compared = files.compared();
    CHECK(compared.following == std::set{Section::hardware});
    REQUIRE(compared.alone.size() == 1);
    CHECK(compared.alone[0].set == Overrides{{"extra", "2"}});
    CHECK(has_text(print_compared(compared), "4 only in B: T800 c[0], T800 c[1], b.link[1] to c[0].link[0], "
                                             "b.link[2] to c[1].link[0]; follows from the vals\n"));
}

TEST_CASE("seed, time limit and order of processes are differences of the runs") {
    ComparedFiles files;
    files.b.seed = 2;
    files.b.shuffle = 3;
    const NetlistComparison compared = files.compared();
    std::vector<std::string> tried;
    for (const OneChange& each : compared.alone)
        tried.push_back(each.what);
    CHECK(tried == std::vector<std::string>{"seed: 1 in A, 2 in B", "the order of ready processes (--shuffle)"});
}

TEST_CASE("if a run does not complete, no difference is tried, and the text says so") {
    const ComparedFiles files(two_transputers, replaced(two_transputers, "sink (count = 1)", "sink (count = 2)"));
    const NetlistComparison compared = files.compared();
    CHECK_FALSE(compared.both_completed());
    CHECK(compared.report_b.result.ending == Ending::stuck);
    CHECK(compared.settings.size() == 1);
    CHECK(compared.alone.empty());
    CHECK(print_compared(compared).ends_with(
        "\nNo difference was applied alone, because one of the runs does not complete.\n"));
}

TEST_CASE("a difference with which A is refused is shown with the reason, and the rest is not said to add up") {
    // B has a third processor and places the sink there; A alone with this placement lacks the processor.
    const ComparedFiles files(two_transputers, replaced(replaced(two_transputers, "a, b;", "a, b, c;"),
                                                        "place sink on b", "place sink on c") +
                                                   "connect b.link[1] to c.link[2];\n");
    const NetlistComparison compared = files.compared();
    REQUIRE(compared.alone.size() == 2);
    CHECK(compared.alone[1].what == "the mapping of B");
    CHECK(compared.alone[1].refused ==
          "this does not fit the rest of A: the name \"c\" is undefined"); // without a line
    CHECK_FALSE(compared.alone[1].completed());
    const std::string text = print_compared(compared);
    CHECK(has_text(text, "not alone  the mapping of B: "));
    CHECK_FALSE(has_text(text, "add up"));
}

TEST_CASE("differences that act on each other leave a rest, which is stated") {
    const std::string parts = replaced(two_transputers, "cycles = cycles", "cycles = cycles * parts");
    const std::string with_parts = "val parts 1;\n" + parts;
    ComparedFiles files(with_parts, with_parts);
    files.b.set = {{"cycles", "2000000"}, {"parts", "2"}};
    const NetlistComparison compared = files.compared();
    REQUIRE(compared.alone.size() == 2); // each adds 50 ms; both together add 150 ms
    CHECK(in_milliseconds(compared.difference()) == test::nearly(150, .01));
    const std::string text = print_compared(compared);
    CHECK(has_text(text, "the sum of these\n"));
    CHECK(has_text(text, " ms remain: the differences interact, and this part appears only if they are combined.\n"));
}

TEST_CASE("an interrupted comparison tries nothing more") {
    const ComparedFiles files(two_transputers, replaced(two_transputers, "val cycles 1000000", "val cycles 3000000"));
    Interruption interruption;
    interruption.request();
    const NetlistComparison compared = compare_runs(files.a, files.b, interruption, [](std::size_t, std::size_t) {});
    CHECK(compared.alone.empty());
    CHECK_FALSE(compared.both_completed());
}
