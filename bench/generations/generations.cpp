// This program measures how many generations per second genetic algorithms make natively: ours with each vector width,
// and rivals. All search the plant of chapter 5 with the same budget. The program also measures how well they follow
// the plant.
//
// usage: generations [SEEDS]

#include "bench/generations/contest.hpp"
#include "gaprocs/search_problem.hpp"
#include "problems/plant/plant_record.hpp"
#include "runtime/fingerprint.hpp"
#include "runtime/random.hpp"
#include "runtime/vector_width.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <limits>

using namespace placedpar;

namespace {

/// Returns the processor time, which other programs on the machine do not affect. No rival uses threads.
double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

constexpr PlantExperiment experiment{}; // the ramp of Table 5.4, without noise

Chase chase_of(std::uint64_t seed) { return {plant_record(experiment, RandomStream(seed, "plant")), seed}; }

/// Returns the rms distance between the estimated and the true pole from generation 100 on. Before, all contestants are
/// still searching. Either pole of a conjugate pair counts as right.
double pole_error(const Chase& chase, const Answer& answer) {
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < answer.poles.size(); ++i) {
        auto generation = static_cast<double>(i * Chase::trials);
        if (generation < 100)
            continue;
        Pole truth = pole_of(a1_at(experiment.change, generation), Plant().a2);
        sum +=
            std::pow(answer.poles[i].alpha - truth.alpha, 2) + std::pow(std::abs(answer.poles[i].beta) - truth.beta, 2);
        ++count;
    }
    return std::sqrt(sum / static_cast<double>(std::min(count, chase.windows())));
}

struct Result {
    Contestant contestant;
    double seconds = std::numeric_limits<double>::infinity(); // time of all chases in the fastest round
    std::vector<Answer> answers;

    void run(std::span<const Chase> chases) {
        answers.clear();
        double start = processor_seconds();
        for (const Chase& chase : chases)
            answers.push_back(contestant.follow(chase));
        seconds = std::min(seconds, processor_seconds() - start);
    }
    double generations_per_s(std::span<const Chase> chases) const {
        return static_cast<double>(chases.size() * chases.front().generations()) / seconds;
    }
    std::vector<double> errors(std::span<const Chase> chases) const {
        std::vector<double> errors;
        for (std::size_t i = 0; i < chases.size(); ++i)
            errors.push_back(pole_error(chases[i], answers[i]));
        std::sort(errors.begin(), errors.end());
        return errors;
    }
    std::uint64_t fingerprint() const {
        Fingerprint all;
        for (const Answer& answer : answers)
            for (const Pole& pole : answer.poles)
                all.mix(std::bit_cast<std::uint64_t>(pole.alpha) ^ std::bit_cast<std::uint64_t>(pole.beta));
        return all.value();
    }
};

/// Returns the time of one error evaluation with the present vector width, in ns: the shortest of several measurements.
double nanoseconds_of_an_evaluation(const Chase& chase, int goes) {
    auto problem = make_search_problem(PlantProblem());
    RandomStream random(1, "evaluations");
    auto population = random_population(Chase::population, problem->bits(), random);
    std::vector<double> fitness(population.size());
    double fastest = std::numeric_limits<double>::infinity();
    for (int go = 0; go < goes; ++go) {
        constexpr int times = 200;
        double start = processor_seconds();
        for (int i = 0; i < times; ++i)
            problem->fitness_of(population, chase.window_at(0), Chase::bias, fitness);
        fastest = std::min(fastest, (processor_seconds() - start) / times);
    }
    return 1e9 * fastest / static_cast<double>(Chase::population * Chase::window);
}

void time_evaluations(const Chase& chase, int goes) {
    fmt::print("one error evaluation, decoding of the strings included:");
    for (std::size_t width : vector_widths) {
        if (width > widest_vector_width())
            break;
        use_vector_width(width);
        fmt::print("{} {:.2f} ns with {} doubles at once", width == 2 ? "" : ",",
                   nanoseconds_of_an_evaluation(chase, goes), width);
    }
    use_vector_width(widest_vector_width());
    fmt::print("\n\n");
}

std::vector<Result> contest(std::span<const Chase> chases, int rounds) {
    std::vector<Result> results;
    for (const auto& group : {ours(), galib(), pagmo()})
        for (const Contestant& contestant : group)
            results.push_back({contestant, std::numeric_limits<double>::infinity(), {}});
    for (int round = 0; round < rounds;
         ++round) // the contestants take turns, so that other load on the machine affects all of them
        for (Result& result : results)
            result.run(chases);
    return results;
}

void print(std::span<const Result> results, std::span<const Chase> chases) {
    double rival = 0; // the fastest rival
    for (const Result& result : results.subspan(ours().size()))
        rival = std::max(rival, result.generations_per_s(chases));
    fmt::print("{:<30}{:>15}{:>22}{:>17}{:>8}\n", "", "generations/s", "of the quickest rival", "pole error", "P90");
    for (const Result& result : results) {
        auto errors = result.errors(chases);
        double speed = result.generations_per_s(chases);
        fmt::print("{:<30}{:>15.0f}{:>22}{:>17.4f}{:>8.4f}\n", result.contestant.name, speed,
                   rival > 0 ? fmt::format("{:.1f}", speed / rival) : "-", errors[(errors.size() - 1) / 2],
                   errors[(errors.size() - 1) * 9 / 10]);
    }
}

} // namespace

int main(int argc, char** argv) {
    long seeds = argc > 1 ? std::strtol(argv[1], nullptr, 10) : 30;
    if (argc > 2 || seeds < 1) {
        fmt::print(stderr, "usage: generations [SEEDS, at least 1]\n");
        return 1;
    }
    const int rounds = seeds < 10 ? 1 : 5;
    std::vector<Chase> chases;
    for (long seed = 1; seed <= seeds; ++seed)
        chases.push_back(chase_of(static_cast<std::uint64_t>(seed)));
    fmt::print("The pole of chapter 5's plant: {} generations of {}, window {}, {} error evaluations; {} seeds\n",
               chases.front().generations(), Chase::population, Chase::window, chases.front().error_evaluations(),
               seeds);
    time_evaluations(chases.front(), 20 * rounds);

    auto results = contest(chases, rounds);
    print(results, chases);
    for (auto [rival, missing] : {std::pair("GAlib", galib().empty()), std::pair("pagmo", pagmo().empty())})
        if (missing)
            fmt::print("{} is missing: fetch it by tools/rivals.sh, then configure again\n", rival);
    fmt::print("fingerprint {:016x}\n", results.front().fingerprint());
    bool same_bits = true;
    for (std::size_t i = 1; i < ours().size() - 3; ++i) // the results of different vector widths
        same_bits = same_bits && results[i].fingerprint() == results.front().fingerprint();
    if (!same_bits)
        fmt::print(stderr, "error: the vector widths gave different answers, but must give the same\n");
    return same_bits ? 0 : 1;
}
