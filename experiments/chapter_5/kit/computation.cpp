#include "experiments/chapter_5/kit/computation.hpp"

#include "experiments/chapter_5/kit/least_squares.hpp"
#include "experiments/chapter_5/kit/tracking.hpp"
#include "experiments/kit/claims.hpp"
#include "experiments/kit/seed_runs.hpp"
#include "problems/plant/plant_problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace placedpar {

namespace {

constexpr double least_times = 30, most_times = 50,
                 breeding_cycles = 1750; // for an individual: examples/thesis/workload.inc
constexpr double short_memory = 0.9;     // the forgetting with which the recursion follows the change

struct CountedSearch {
    std::size_t window, per_sample;
    ClaimVerdict by_operations; ///< expected; by the other measures the search takes more than 50 times as much

    std::string name() const { return fmt::format("window {}, {} generations a sample", window, per_sample); }
    PlantIslands islands() const {
        PlantIslands islands{.name = name(), .windows = {window}};
        islands.plant.per_sample = per_sample;
        return islands;
    }
};

constexpr CountedSearch counted_searches[]{{10, 1, ClaimVerdict::holds},
                                           {30, 1, ClaimVerdict::fails},
                                           {10, 3, ClaimVerdict::fails},
                                           {30, 3, ClaimVerdict::fails}};

/// Returns the number of answers up to the first one from which ten are near the true pole.
double answers_to_pole(const std::vector<Pole>& answers) {
    const Pole truth = pole_of(Plant().a1, Plant().a2);
    std::size_t near = 0, taken = 0;
    for (; taken < answers.size() && near < 10; ++taken)
        near = std::hypot(answers[taken].alpha - truth.alpha, answers[taken].beta - truth.beta) < found_pole ? near + 1
                                                                                                             : 0;
    return static_cast<double>(taken - near + 1);
}

double samples_of_recursion(std::uint64_t seed) {
    RecursiveIdentification recursion(short_memory);
    std::vector<Pole> answers;
    for (const Sample& sample : plant_samples({}, seed)) {
        recursion.push(sample);
        answers.push_back(recursion.plant().pole());
    }
    return answers_to_pole(answers);
}

double samples_of_search(const CountedSearch& search, std::uint64_t seed) {
    return answers_to_pole(search_plant(search.islands(), seed).islands.front()) /
           static_cast<double>(search.per_sample);
}

Comparison by_sample(const Operations& recursion) {
    Comparison comparison{.name = "genetic algorithm of 100 over recursive least squares, for each sample",
                          .judged = true};
    for (const CountedSearch& search : counted_searches) {
        const PlantIslands islands = search.islands();
        Operations operations = operations_of_search(islands);
        double bred = static_cast<double>(islands.populations[0] * search.per_sample);
        auto add = [&](const char* column, double times, ClaimVerdict expected) {
            Cell cell = plain_cell(search.name(), column, "", times, 1);
            bool holds = expected == ClaimVerdict::holds;
            cell.at_least = holds ? least_times : most_times;
            cell.at_most = holds ? std::optional(most_times) : std::nullopt;
            comparison.add(cell);
        };
        comparison.add(plain_cell(search.name(), "operations", "", operations.all(), 0));
        comparison.add(plain_cell(search.name(), "of recursion", "", recursion.all(), 0));
        add("times", operations.all() / recursion.all(), search.by_operations);
        add("times, T800", (operations.t800_cycles() + bred * breeding_cycles) / recursion.t800_cycles(),
            ClaimVerdict::fails);
    }
    return comparison;
}

} // namespace

Operations operations_of_search(const PlantIslands& islands) {
    const PlantProblem problem;
    const Sample sample(plant_channels, 1.0);
    auto value = [&](std::size_t parameter) {
        const ParameterField& field = problem.coding().field(parameter);
        return Counted(field.low) + Counted(field.resolution()) * 0.0;
    };
    Operations one = Counted::in([&] {
        auto weights = PoleZeroPlantOf<Counted>{value(0), value(1), value(2), value(3), value(4), value(5)}.weights();
        Counted fitness;
        for (std::size_t i = 0; i < islands.windows[0]; ++i) {
            Counted error = problem.error_of<Counted>(weights, sample);
            fitness += islands.bias - error * error;
        }
    });
    auto times = static_cast<double>(islands.populations[0] * islands.plant.per_sample);
    return {times * one.additions, times * one.multiplications, times * one.divisions};
}

Operations operations_of_recursion() {
    return Counted::in([] {
        for (std::size_t delay = 1; delay <= LinearPlant::delays; ++delay) {
            RecursiveEstimate<Counted> estimate(LinearPlant::coefficients);
            const std::vector<Counted> inputs(LinearPlant::coefficients, 1.0);
            Counted error = estimate.take(inputs, 1.0, short_memory), squared_error;
            squared_error = squared_error * short_memory + error * error;
        }
    });
}

std::vector<Comparison> computation_comparisons(const ReplayContext& context) {
    const Operations recursion = operations_of_recursion();
    std::vector<Claim> claims;
    for (const CountedSearch& search : counted_searches) {
        auto runs = run_seeds(context, "first answer, " + search.name(), [=](std::uint64_t seed) {
            return Figures{samples_of_search(search, seed) / samples_of_recursion(seed)};
        });
        double times = operations_of_search(search.islands()).all() / recursion.all();
        std::vector<double> quotients = column(runs, 0);
        std::ranges::for_each(quotients, [=](double& each) { each *= times; });
        claims.push_back({search.name(), "times", quotients, least_times, most_times, ClaimVerdict::fails});
    }
    return {by_sample(recursion), claims_comparison("operations until ten answers are near the pole", claims)};
}

} // namespace placedpar
