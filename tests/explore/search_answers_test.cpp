// Tests which answers of a run with several searches are kept.

#include "explore/search_answers.hpp"

#include "explore/load.hpp"
#include "explore/netlist_run.hpp"
#include "explore/problems.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace placedpar;

namespace {

const std::filesystem::path sixteen = PLACEDPAR_SOURCE_DIR "/examples/thesis/figure-e2/figure-e2.cfs";

const std::vector<std::string> masters{"master[0]", "master[1]", "master[2]", "master[3]"};

/// An observed run of Figure E.2 on the boom.
struct ObservedRun {
    ProblemRegistry problems;
    SearchAnswers answers;
    RunReport report;

    explicit ObservedRun(const std::string& problem, std::uint64_t seed = 1)
        : problems(known_problems(seed)), answers(masters, problems.find(problem).problem()) {
        const std::string quoted = '"' + problem + '"';
        const Overrides set{{"host.problem", quoted}, {"master.problem", quoted}, {"slave.problem", quoted}};
        Network network = load_network(sixteen, set, problems, [](const std::string& warning) { FAIL(warning); });
        report = run_netlist(network, problems, {.seed = seed, .observer = &answers});
    }
};

} // namespace

TEST_CASE("the last answers are those that the islands measure") {
    const ObservedRun run("boom");
    const std::size_t last = run.answers.generations() - 1;
    CHECK(last == 79);
    std::vector<double> found, fitness;
    for (std::size_t island = 0; island < masters.size(); ++island) {
        found.push_back(run.report.measured(masters[island], "C_BOi"));
        fitness.push_back(run.report.measured(masters[island], "best_fitness"));
        CHECK(run.answers.of(island, last).values == std::vector{found.back()});
    }
    CHECK(fitness[run.answers.fittest(last)] == std::ranges::max(fitness));
    CHECK(run.answers.spread(last, 0) == std::ranges::max(found) - std::ranges::min(found));
    CHECK(run.answers.ready(0) < run.answers.ready(last));
    CHECK(run.answers.ready(last) <= run.report.result.time);
}

TEST_CASE("both problems of the boom have its compliance as the answer") {
    for (const char* problem : {"boom", "boom-by-voltage"}) {
        const ObservedRun run(problem);
        const std::size_t last = run.answers.generations() - 1;
        CHECK(std::abs(run.answers.of(run.answers.fittest(last), last).values[0] / 0.0086 - 1) < 0.1);
    }
}

TEST_CASE("the boom's areas by voltage differ from its areas by spool") {
    const ProblemRegistry problems = known_problems(1);
    const auto &by_spool = problems.find("boom").record(), &by_voltage = problems.find("boom-by-voltage").record();
    REQUIRE(by_spool.size() == by_voltage.size());
    CHECK(by_spool != by_voltage);
}

TEST_CASE("an unknown search is a defect") {
    SearchAnswers answers({"other"}, known_problems(1).find("boom").problem());
    CHECK(answers.generations() == 0);
    const ProblemRegistry problems = known_problems(1);
    Network network = load_network(sixteen, {}, problems, [](const std::string&) {});
    CHECK_THROWS(run_netlist(network, problems, {.seed = 1, .observer = &answers}));
}
