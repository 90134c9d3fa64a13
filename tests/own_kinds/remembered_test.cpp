// Tests a problem that is expensive to evaluate: a worker evaluates each string once, even if other settings change.

#include "explore/problems.hpp"
#include "explore/study/remembered_problem.hpp"
#include "explore/study/sweep.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <tuple>
#include <utility>
#include <vector>

using namespace placedpar;

namespace {

/// Counts the evaluations of each point.
std::map<std::pair<double, double>, int>& evaluations() {
    static std::map<std::pair<double, double>, int> all;
    return all;
}

struct DearBowl {
    static constexpr std::string_view name = "own.dear", about = "a bowl that takes 20 microseconds or more";
    static constexpr std::tuple<> numbers() { return {}; }
    ParameterCoding representation() const { return ParameterCoding(2, {-4, 4, 6}); }
    double objective(std::span<const double> x) const {
        ++evaluations()[{x[0], x[1]}];
        std::this_thread::sleep_for(std::chrono::microseconds(20));
        return (x[0] - 0.3) * (x[0] - 0.3) / 3 + x[1] * x[1] / 7;
    }
};

/// A netlist with a search for the problem, deleted after the tests.
struct DearNetlist {
    DearNetlist() {
        std::ofstream(path) << R"(val problem "own.dear"; val coding "gray"; val generations 12;
workstation sun; T800 t; connect sun.link[0] to t.link[0];
process (interface (output to_masters[1])) host; use "ga.host" for host; place host on sun;
host (problem = problem, generations = generations);
process (interface (input from_host)) search; use "ga.traditional" for search; place search on t;
search (problem = problem, population = 20, elite = 1, coding = coding);
connect host.to_masters[0] to search.from_host;
)";
    }
    ~DearNetlist() { std::filesystem::remove(path); }
    const std::filesystem::path path =
        std::filesystem::temp_directory_path() / fmt::format("placedpar-dear-{}.cfs", ::getpid());
};

Study study_of_dear(const std::vector<std::string>& settings, std::uint64_t seeds) {
    static const bool known = (add_own_problems({minimised<DearBowl>()}), true);
    REQUIRE(known);
    static const DearNetlist netlist;
    Study study;
    study.netlist = netlist.path.string();
    study.products.emplace_back();
    for (const std::string& setting : settings)
        study.products.back().axes.push_back(read_axis(setting));
    study.seeds = seeds;
    return study;
}

std::string outcome_in_words(StudyWorker& worker, const StudyRun& run) {
    Interruption never;
    std::optional<StudyOutcome> outcome = worker.outcome_of(run, never);
    REQUIRE(outcome);
    CHECK(outcome->ended == "completed");
    return fmt::format("{} {} {:016x} {} {}", outcome->ended, to_string(outcome->time), outcome->fingerprint,
                       outcome->refused, figures_text(outcome->figures));
}

} // namespace

TEST_CASE("a worker evaluates a string of an own problem once, and its runs come to what they come to alone") {
    for (std::uint64_t seeds : {1U, 3U}) {
        Study study = study_of_dear({"linkspeed=5M,10M,20M", "coding=gray", "generations=6,12"}, seeds);
        std::vector<std::string> alone;
        for (std::uint64_t i = 0; i < study.count(); ++i) {
            StudyWorker other(study);
            alone.push_back(outcome_in_words(other, *study.at(i)));
        }
        evaluations().clear();
        StudyWorker worker(study);
        for (std::uint64_t i = 0; i < study.count(); ++i) {
            CAPTURE(i);
            CHECK(outcome_in_words(worker, *study.at(i)) == alone[i]);
        }
        CHECK(evaluations().size() > 50);
        for (const auto& each : evaluations())
            CHECK(each.second == 1);
    }
}
