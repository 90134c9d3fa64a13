// Tests how a study's combinations become the machines of a search, and how trials of machines are judged.

#include "explore/optimise/machine_space.hpp"

#include "explore/optimise/trials.hpp"
#include "explore/study/results.hpp"
#include "gaprocs/representation/genome.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

using namespace placedpar;

namespace {

Study study_with(const std::vector<std::string>& axes, const std::string& where = "") {
    Study study;
    study.products.push_back({.axes = {}, .where = StudyExpression(where)});
    for (const std::string& each : axes)
        study.products[0].axes.push_back(read_axis(each));
    study.search = StudySearch{.minimise = {"time"}};
    return study;
}

/// Returns the genome whose bits are the natural binary number.
Genome genome_of_number(std::uint64_t number, std::size_t bits) {
    std::string text;
    for (std::size_t i = bits; i-- > 0;)
        text += number >> i & 1 ? '1' : '0';
    return Genome::from_string(text);
}

/// Results in memory, in which the test keeps the outcomes of runs.
struct KeptTrials {
    Study study;
    MachineSpace space;
    StudyResults results{StudySource{}};
    Interruption never;

    explicit KeptTrials(Study searched) : study(std::move(searched)), space(study) {}

    void keep(const Overrides& set, std::uint64_t seed, const StudyOutcome& outcome) {
        results.keep({set, seed}, outcome);
    }
    Trial trial_of(std::uint64_t machine) {
        MachineTrials trials(study, space, results, 1, never);
        REQUIRE(trials.try_out(std::vector{machine}, [](std::uint64_t) {}));
        return trials.of(machine);
    }
};

StudyOutcome completed_in(double ms) { return {.ended = "completed", .figures = {{"time", {ms, "ms"}}}}; }

} // namespace

TEST_CASE("a genome has the bits that its settings need; settings with one value need none") {
    const Study study = study_with({"a=0..7", "once=3", "b=0..4"});
    const MachineSpace space(study);
    CHECK(space.count() == 40);
    CHECK(space.bits() == 3 + 3);
    CHECK(space.names() == std::vector<std::string>{"a", "b"});
    CHECK(space.fixed() == Overrides{{"once", "3"}});
    CHECK(space.settings(39) == Overrides{{"a", "7"}, {"once", "3"}, {"b", "4"}});
}

TEST_CASE("if a setting has a power of two of values, each code is one value; the last setting varies fastest") {
    const Study study = study_with({"a=0..3", "b=0..7"});
    const MachineSpace space(study);
    for (std::uint64_t machine = 0; machine < 32; ++machine)
        CHECK(space.machine_of(genome_of_number(machine, 5)) == machine);
}

TEST_CASE("the codes of a field are spread evenly: each value has one code or two") {
    const Study study = study_with({"a=0..4"}); // 8 codes for 5 values
    const MachineSpace space(study);
    std::map<std::uint64_t, int> codes;
    for (std::uint64_t code = 0; code < 8; ++code)
        ++codes[space.machine_of(genome_of_number(code, 3))];
    CHECK(codes.size() == 5);
    for (const auto& [machine, count] : codes) {
        CHECK(machine < 5);
        CHECK(count <= 2);
    }
}

TEST_CASE("a space may have as many machines as 64 bits can count, and no more") {
    const Study large = study_with({"a=0..4294967295", "b=0..4294967294"});
    CHECK(MachineSpace(large).count() == 18446744069414584320U);
    CHECK(MachineSpace(large).bits() == 64);
    const Study larger = study_with({"a=0..4294967295", "b=0..4294967295"});
    CHECK_THROWS_AS(MachineSpace{larger}, UserError);
}

TEST_CASE("machines for which the condition does not hold are counted, but do not hold") {
    const Study study = study_with({"a=0..1", "b=0..1"}, "a != b");
    const MachineSpace space(study);
    CHECK(space.count() == 4);
    CHECK_FALSE(space.holds(0));
    CHECK(space.holds(1));
    CHECK(space.holds(2));
    CHECK_FALSE(space.holds(3));
}

TEST_CASE("a space without a choice, or with several products, is refused") {
    const Study fixed = study_with({"a=1", "b=2"});
    CHECK_THROWS_WITH_AS(MachineSpace{fixed},
                         "the search has nothing to choose: give some setting in [set] several values", UserError);
    Study several = study_with({"a=1,2"});
    several.products.push_back(several.products[0]);
    CHECK_THROWS_AS(MachineSpace{several}, UserError);
}

TEST_CASE("a machine costs the mean of its runs with all seeds") {
    KeptTrials kept(study_with({"a=0..1"}));
    kept.study.seeds = 2;
    kept.keep({{"a", "0"}}, 1, completed_in(4));
    kept.keep({{"a", "0"}}, 2, completed_in(6));
    const Trial trial = kept.trial_of(0);
    CHECK(trial.simulated);
    CHECK(trial.merit.feasible);
    CHECK(trial.merit.costs == std::vector<double>{5});
    CHECK(trial.why == "");
}

TEST_CASE("a machine is infeasible if a run is refused, does not complete or lacks the measure; the reason is kept") {
    const auto why = [](const StudyOutcome& second) {
        KeptTrials kept(study_with({"a=0..1"}));
        kept.study.seeds = 2;
        kept.keep({{"a", "0"}}, 1, completed_in(4));
        kept.keep({{"a", "0"}}, 2, second);
        const Trial trial = kept.trial_of(0);
        CHECK_FALSE(trial.merit.feasible);
        CHECK(trial.simulated);
        return trial.why;
    };
    CHECK(why({.ended = "deadlock"}) == "deadlock");
    CHECK(why({.ended = "refused", .refused = "too few links"}) == "too few links");
    CHECK(why({.ended = "completed"}) == "a run did not measure time");
}

TEST_CASE("a machine against the condition is not run") {
    KeptTrials kept(study_with({"a=0..1"}, "a > 0")); // there is no netlist, so a run would fail
    const Trial trial = kept.trial_of(0);
    CHECK_FALSE(trial.simulated);
    CHECK(trial.why == "the study's condition \"where\" is not met");
}

TEST_CASE("a study of some settings has their runs only, and everything else of the study") {
    Study study = study_with({"a=0..9"});
    study.netlist = "n.cfs";
    study.seeds = 3;
    study.first_seed = 7;
    study.prices = {{"T800", 300}};
    const Study some = study_of(study, {{{"a", "4"}}, {{"a", "2"}, {"b", "\"x,y\""}}});
    CHECK(some.count() == 6);
    CHECK(some.at(0) == StudyRun{{{"a", "4"}}, 7});
    CHECK(some.at(5) == StudyRun{{{"a", "2"}, {"b", "\"x,y\""}}, 9});
    CHECK(some.netlist == "n.cfs");
    CHECK(some.prices == study.prices);
    CHECK(study_of(study, {}).count() == 0);
}
