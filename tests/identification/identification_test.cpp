// Tests identification of the boom's compliance over 50 seeds, against figures of an independent prototype.
#include "gaprocs/traditional.hpp"
#include "gaprocs/window.hpp"
#include "hydraulics/plant/excavator_record.hpp"
#include "hydraulics/plant/excavator_values.hpp"
#include "identification/circuit_problem.hpp"
#include "text/statistics.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <span>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;

namespace {

constexpr std::uint64_t study_seeds = 50;
constexpr double true_compliance = 0.0086;

struct Study {
    std::vector<double> error_percent;      ///< error of the last estimate, for each seed
    std::vector<double> codes_from_optimum; ///< distance to the best of all 1024 codes
};

/// Returns the code of greatest fitness in the last window.
std::uint64_t exhaustive_optimum(const SearchProblem& problem, std::span<const Sample> window) {
    std::uint64_t best = 0;
    double greatest = -1e300;
    for (std::uint64_t code = 0; code < 1024; ++code) {
        Genome genome(10);
        genome.set_field(0, 10, code);
        if (double fitness = problem.fitness(genome, window, 400); fitness > greatest) {
            greatest = fitness;
            best = code;
        }
    }
    return best;
}

Study study(const MeasurementNoise& noise) {
    ExcavatorScenario scenario = single_boom_scenario();
    auto problem = make_search_problem(CircuitProblem(boom_circuit(), scenario.flow));
    Study result;
    for (std::uint64_t seed = 1; seed <= study_seeds; ++seed) {
        RandomStream sensors(seed, "sensors");
        auto record = boom_record(scenario, noise, [&] { return sensors.uniform(); });
        REQUIRE(record.size() == 20);
        SearchResult search = run_traditional(*problem, record, {}, RandomStream(seed, "search"));
        const Estimate& last = search.estimates.back();
        result.error_percent.push_back(100 * std::abs(last.parameters.at(0) / true_compliance - 1));
        auto optimum = exhaustive_optimum(*problem, std::span(record).last(10));
        auto found = last.best.genome.field(0, 10);
        result.codes_from_optimum.push_back(std::abs(static_cast<double>(found) - static_cast<double>(optimum)));
    }
    return result;
}

void check_study(const Study& study, double median_percent, double ninetieth_percent) {
    CAPTURE(lower_median(study.error_percent));
    CAPTURE(quantile(study.error_percent, 0.9));
    CAPTURE(quantile(study.codes_from_optimum, 0.9));
    CHECK(lower_median(study.error_percent) <= median_percent);
    CHECK(quantile(study.error_percent, 0.9) <= ninetieth_percent);
    CHECK(quantile(study.codes_from_optimum, 0.9) <= 3);
}

} // namespace

TEST_CASE("identification without noise: every seed within 10 %") {
    Study none = study(no_noise);
    check_study(none, 1.5, 4);
    CHECK(quantile(none.error_percent, 1) <= 10);
}

TEST_CASE("identification at low noise: every seed within 10 %") {
    Study low = study(low_noise);
    check_study(low, 3.5, 8);
    CHECK(quantile(low.error_percent, 1) <= 10);
}

TEST_CASE("identification at mid noise: most seeds within 10 %") { check_study(study(mid_noise), 6, 13); }

TEST_CASE("identification at high noise: the 90th percentile exceeds 10 %") {
    CHECK(quantile(study(high_noise).error_percent, 0.9) > 10);
}
