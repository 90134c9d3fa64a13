#include "experiments/chapter_5/kit/computation.hpp"
#include "experiments/chapter_5/kit/covariance_adaptation.hpp"
#include "experiments/chapter_5/kit/differential_evolution.hpp"
#include "experiments/chapter_5/kit/least_squares.hpp"
#include "experiments/chapter_5/kit/plant_study.hpp"
#include "experiments/kit/experiment.hpp"
#include "problems/plant/plant_problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace placedpar {

namespace {

constexpr std::size_t searchers = 100; ///< points of a population, as in the thesis's single genetic algorithm
/// The lower limit of the step of a CovarianceAdaptation (CMA-ES), with which it keeps exploring.
constexpr double least_step = 0.02;
/// Bounds for the additional lag: the lag minus the lag of least squares over the same window, in generations. Genetic
/// algorithms are claimed to have an additional lag of at least `least_lag_beyond`, and searches over real numbers of
/// at most `most_lag_beyond`.
constexpr double least_lag_beyond = 10, most_lag_beyond = 5;
/// The coefficient c1 of coloured noise.
constexpr double colour = 0.8;

/// Returns the pole found in each generation. It is computed by `find(samples, is_new)`, where `samples` are the
/// samples so far, and `is_new` says whether a sample is new in this generation.
template <class Find>
std::vector<Pole> follow_record(const PlantExperiment& plant, std::uint64_t seed, Find find) {
    auto samples = plant_samples(plant, seed);
    std::vector<Pole> found;
    for (std::size_t generation = 0; generation < plant.generations; ++generation) {
        std::size_t seen = plant.window + generation / plant.per_sample;
        found.push_back(find(std::span<const Sample>(samples).first(seen), generation % plant.per_sample == 0));
    }
    return found;
}

/// Follows the pole by least squares over the last `window` samples.
std::vector<Pole> follow_by_least_squares(const PlantExperiment& plant, std::uint64_t seed, std::size_t window) {
    Pole pole{};
    return follow_record(plant, seed, [&](std::span<const Sample> seen, bool is_new) {
        if (is_new)
            pole = least_squares(seen.last(window)).pole();
        return pole;
    });
}

std::vector<Pole> follow_recursively(const PlantExperiment& plant, std::uint64_t seed,
                                     RecursiveIdentification identification) {
    std::size_t taken = 0;
    return follow_record(plant, seed, [&](std::span<const Sample> seen, bool) {
        for (; taken < seen.size(); ++taken)
            identification.push(seen[taken]);
        return identification.plant().pole();
    });
}

/// Maps a point of the unit cube to the parameters of Table 5.1, and computes the sum of squared errors over a window
/// for these parameters.
class PlantCube {
public:
    PoleZeroPlant plant(const Eigen::VectorXd& point) const {
        std::array<double, 6> parameters{};
        for (std::size_t i = 0; i < parameters.size(); ++i) {
            const ParameterField& field = problem_.coding().field(i);
            parameters[i] = field.rounded(field.low + (field.high - field.low) * point[static_cast<Eigen::Index>(i)]);
        }
        auto [d, alpha, beta, gamma, delta, b0] = parameters;
        return {d, alpha, beta, gamma, delta, b0};
    }
    Pole pole(const Eigen::VectorXd& point) const {
        PoleZeroPlant found = plant(point);
        return {found.alpha, std::abs(found.beta)};
    }
    Objective01 squared_error(std::span<const Sample> window) const {
        return [this, window](const Eigen::VectorXd& point) {
            auto weights = plant(point).weights();
            double sum = 0;
            for (const Sample& sample : window) {
                double error = problem_.error_of<double>(weights, sample);
                sum += error * error;
            }
            return sum;
        };
    }

private:
    PlantProblem problem_;
};

std::vector<Pole> follow_by_differential_evolution(const PlantExperiment& plant, std::uint64_t seed) {
    PlantCube cube;
    DifferentialEvolution evolution(6, searchers, RandomStream(seed, "differential evolution"));
    return follow_record(plant, seed, [&](std::span<const Sample> seen, bool is_new) {
        Objective01 error = cube.squared_error(seen.last(plant.window));
        if (is_new)
            evolution.evaluate(error);
        evolution.next_generation(error);
        return cube.pole(evolution.best());
    });
}

std::vector<Pole> follow_by_covariance(const PlantExperiment& plant, std::uint64_t seed, double step) {
    PlantCube cube;
    CovarianceAdaptation strategy(6, searchers, step, RandomStream(seed, "covariance adaptation"));
    return follow_record(plant, seed, [&](std::span<const Sample> seen, bool) {
        strategy.next_generation(cube.squared_error(seen.last(plant.window)));
        return cube.pole(strategy.mean());
    });
}

std::vector<Pole> follow_by_forgetting(const PlantExperiment& plant, std::uint64_t seed, double forgetting) {
    return follow_recursively(plant, seed, RecursiveIdentification(forgetting));
}

PlantIslands in_gray_code(PlantIslands islands) {
    islands.name += ", Gray code";
    islands.coding = Coding::gray;
    return islands;
}

using NoiseTerms = RecursiveLeastSquares::NoiseTerms;

std::vector<PlantStudy> searches(const ReplayContext& context, PlantExperiment plant) {
    auto with_plant = [&](PlantIslands islands) {
        islands.plant = plant;
        return study_plant(context, islands);
    };
    std::vector<PlantStudy> studies;
    studies.push_back(with_plant(single_ga(0)));
    studies.push_back(with_plant(in_gray_code(single_ga(0))));
    studies.push_back(study_pole(context, "differential evolution, window 30", plant,
                                 [=](std::uint64_t seed) { return follow_by_differential_evolution(plant, seed); }));
    for (double step : {0.0, least_step})
        studies.push_back(study_pole(context, fmt::format("CMA-ES, window 30, least step {}", step), plant,
                                     [=](std::uint64_t seed) { return follow_by_covariance(plant, seed, step); }));
    return studies;
}

std::vector<PlantStudy> estimates(const ReplayContext& context, PlantExperiment plant) {
    std::vector<PlantStudy> studies;
    for (std::size_t window : {10u, 30u})
        studies.push_back(study_pole(context, fmt::format("least squares, window {}", window), plant,
                                     [=](std::uint64_t seed) { return follow_by_least_squares(plant, seed, window); }));
    for (double forgetting : {0.9, 0.95, 0.98})
        studies.push_back(
            study_pole(context, fmt::format("recursive least squares, forgetting {}", forgetting), plant,
                       [=](std::uint64_t seed) { return follow_by_forgetting(plant, seed, forgetting); }));
    for (double forgetting : {0.9, 0.98})
        studies.push_back(study_pole(
            context, fmt::format("extended least squares, forgetting {}", forgetting), plant, [=](std::uint64_t seed) {
                return follow_recursively(plant, seed, RecursiveIdentification(forgetting, NoiseTerms::two));
            }));
    return studies;
}

/// Judges least squares, which finds the optimum of the genetic algorithms' fitness over the same window. So without
/// noise, the genetic algorithms cannot follow a change sooner than least squares. Least squares finds the unchanged
/// plant nearly exactly.
Comparison judged_optimum(const std::vector<PlantStudy>& exact, const std::vector<PlantStudy>& searched) {
    Comparison comparison{.name = "least squares as the exact optimum, noiseless", .against = "known"};
    const PlantStudy& optimum = exact[1];
    comparison.add(at_most(
        1e-6, plain_cell(optimum.islands.name, "error before", "", optimum.median(0, Tracking::error_before), 9)));
    for (const PlantStudy& study : {searched[0], searched[1]})
        comparison.add(at_least(0, plain_cell(study.islands.name, "additional lag", "generations",
                                              study.median(0, Tracking::lag) - optimum.median(0, Tracking::lag), 1)));
    return comparison;
}

/// Returns claims about the additional lag of the searches: for each seed, the lag minus the lag of least squares over
/// the same window.
std::vector<Claim> claims_of(const std::vector<PlantStudy>& exact, const std::vector<PlantStudy>& searched) {
    auto lag_beyond = [&](const PlantStudy& study) { return less(study.lags(), exact[1].lags()); };
    auto claim = [&](const PlantStudy& study) { return "lag beyond least squares, " + study.islands.name; };
    std::vector<Claim> claims;
    for (const PlantStudy& study : {searched[0], searched[1]})
        claims.push_back({claim(study), "generations", lag_beyond(study), least_lag_beyond, {}});
    for (const PlantStudy& study : {searched[2], searched[3]})
        claims.push_back({claim(study), "generations", lag_beyond(study), {}, most_lag_beyond});
    return claims;
}

struct NoiseScenario {
    const char* name;
    PlantExperiment plant;
};

Replay replay_baselines(const ReplayContext& context) {
    const std::vector<NoiseScenario> scenarios{
        {"noiseless", {}},
        {"white noise, sigma = 0.3", {.noise = 0.3}},
        {"coloured noise, sigma = 0.3, c1 = .8", {.noise = 0.3, .colour = {colour, 0}}}};
    std::vector<Comparison> comparisons(1);
    Plot plot{"Other methods than genetic algorithms that follow the pole, " + median_of_seeds(context), {}};
    for (const NoiseScenario& scenario : scenarios) {
        auto searched = searches(context, scenario.plant), exact = estimates(context, scenario.plant);
        if (scenario.plant.noise == 0)
            comparisons.front() = judged_optimum(exact, searched);
        auto rows = study_rows(searched), others = study_rows(exact);
        plot.panels.push_back(pole_panel("searches, " + std::string(scenario.name), rows));
        plot.panels.push_back(pole_panel("estimates, " + std::string(scenario.name), others));
        rows.insert(rows.end(), others.begin(), others.end());
        comparisons.push_back(tracks_comparison(std::string("medians, ") + scenario.name, rows));
        comparisons.push_back(
            claims_comparison(std::string("claims, ") + scenario.name, claims_of(exact, searched), Judge::own));
    }
    std::ranges::move(computation_comparisons(context), std::back_inserter(comparisons));
    return replay_of(std::move(comparisons), {{"baselines", plot}});
}

} // namespace

extern const Experiment baselines_experiment{
    .name = "baselines",
    .about = "least squares, recursive and extended, differential evolution and CMA-ES on the plant of chapter 5",
    .chapter = "5",
    .number = 6,
    .run = replay_baselines,
    .seeds = plant_seeds,
};

} // namespace placedpar
