#include "experiments/chapter_5/kit/computation.hpp"

#include "experiments/chapter_5/kit/least_squares.hpp"
#include "experiments/chapter_5/kit/plant_islands.hpp"
#include "experiments/chapter_5/kit/tracking.hpp"
#include "experiments/kit/claims.hpp"
#include "experiments/kit/seed_runs.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace placedpar {

namespace {

constexpr double least_times = 30, most_times = 50;
constexpr double breeding_cycles = 1750; ///< cycles of breeding an individual (examples/thesis/workload.inc)

/// Returns the number of answers until the pole is found: the position of the first of ten answers in a row that are
/// near the true pole.
double answers_to_pole(const std::vector<Pole>& answers) {
    const Pole truth = pole_of(Plant().a1, Plant().a2);
    std::size_t taken = 0;
    for (std::size_t near = 0; taken < answers.size() && near < 10; ++taken) {
        double distance = std::hypot(answers[taken].alpha - truth.alpha, answers[taken].beta - truth.beta);
        near = distance < found_pole ? near + 1 : 0;
    }
    return static_cast<double>(taken) - 9;
}

double samples_of_recursion(std::uint64_t seed) {
    // The forgetting factor is .9, because the experiment `baselines` shows that only this factor follows the change.
    RecursiveIdentification recursion(0.9);
    std::vector<Pole> answers;
    for (const Sample& sample : plant_samples({}, seed)) {
        recursion.push(sample);
        answers.push_back(recursion.plant().pole());
    }
    return answers_to_pole(answers);
}

/// Adds the cost per sample of a search, divided by the cost per sample of recursive least squares. `as_claimed` says
/// whether the quotient of the operations, without breeding, is expected to be within the claimed bounds.
void add_sample(Comparison& comparison, const PlantIslands& search, bool as_claimed) {
    const double individuals = static_cast<double>(search.populations[0] * search.plant.per_sample);
    const Operations fitness = operations_of_fitness(static_cast<double>(search.windows[0])),
                     recursion = operations_of_recursion(LinearPlant::coefficients);
    auto add = [&](const char* column, double of_individual, double of_delay, bool expected) {
        Cell cell =
            plain_cell(search.name, column, "", individuals * of_individual / (LinearPlant::delays * of_delay), 1);
        cell.at_least = expected ? least_times : most_times;
        if (expected)
            cell.at_most = most_times;
        comparison.add(cell);
    };
    add("times the operations", fitness.all(), recursion.all(), as_claimed);
    add("times the T800's cycles", fitness.t800_cycles() + breeding_cycles, recursion.t800_cycles(), false);
}

} // namespace

Operations operations_of_fitness(double window) { return {8 + 10 * window, 14 + 9 * window, 0}; }

Operations operations_of_recursion(double unknowns) {
    const double squares = unknowns * unknowns, halves = unknowns * (unknowns + 1) / 2;
    return {squares + 2 * unknowns + halves + 1, squares + 3 * unknowns + halves + 2, unknowns + halves};
}

std::vector<Comparison> computation_comparisons(const ReplayContext& context) {
    Comparison samples{.name = "a genetic algorithm of 100 over recursive least squares, for each sample",
                       .judged = true};
    std::vector<Claim> claims;
    for (auto [window, per_sample] : {std::pair(10u, 1u), {30u, 1u}, {10u, 3u}, {30u, 3u}}) {
        PlantIslands search{.name = fmt::format("window {}, generations a sample: {}", window, per_sample),
                            .windows = {window}};
        search.plant.per_sample = per_sample;
        add_sample(samples, search, window * per_sample == 10);
        auto runs = run_seeds(context, search.name, [=, window = window](std::uint64_t seed) {
            double generations = answers_to_pole(search_plant(search, seed).islands[0]);
            return Figures{100 * generations * operations_of_fitness(window).all() /
                           (samples_of_recursion(seed) * LinearPlant::delays *
                            operations_of_recursion(LinearPlant::coefficients).all())};
        });
        claims.push_back({search.name, "times", column(runs, 0), least_times, most_times, ClaimVerdict::fails});
    }
    return {samples, claims_comparison("operations until the pole is found", claims)};
}

} // namespace placedpar
