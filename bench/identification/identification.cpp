// This program measures how fast our algorithms and rivals identify a compliance natively, and how good their answers
// are. All use the same records and the same budget. The machine of the thesis took 0.8 s for such a transient on
// sixteen T800s, and 10 s on one T800.
//
// usage: identification [SEEDS]

#include "bench/identification/contest.hpp"
#include "gaprocs/representation/genome.hpp"
#include "gaprocs/search_problem.hpp"
#include "hydraulics/plant/excavator_record.hpp"
#include "hydraulics/plant/excavator_values.hpp"
#include "runtime/fingerprint.hpp"
#include "runtime/random.hpp"
#include "runtime/vector_width.hpp"
#include "text/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <limits>

using namespace placedpar;
using namespace placedpar::hydraulics;
namespace {

/// Returns the processor time, which other programs on the machine do not affect. No rival uses threads.
double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

Transient transient_of(std::uint64_t seed) {
    ExcavatorScenario scenario = single_boom_scenario();
    RandomStream sensors(seed, "sensors");
    Transient transient{{}, scenario.flow, seed};
    for (const auto& values : boom_record(scenario, low_noise, [&] { return sensors.uniform(); }))
        transient.record.push_back(LinkSample::from(values));
    return transient;
}

struct Result {
    Contestant contestant;
    double seconds = std::numeric_limits<double>::infinity(); // time of all transients in the fastest round
    std::uint64_t error_evaluations = 0;
    std::vector<double> compliances;

    void run(std::span<const Transient> transients) {
        compliances.clear();
        error_evaluations = 0;
        double start = processor_seconds();
        for (const Transient& transient : transients) {
            Answer answer = contestant.identify(transient);
            compliances.push_back(answer.compliance);
            error_evaluations += answer.error_evaluations;
        }
        seconds = std::min(seconds, processor_seconds() - start);
    }
};

/// Returns the compliance with the greatest fitness in the last window, among 65536 equally spaced values.
double optimum(const Transient& transient) {
    constexpr int codes = 1 << 16;
    auto window = transient.window_at(transient.windows() - 1);
    double best = 0, greatest = -std::numeric_limits<double>::infinity();
    for (int code = 0; code < codes; ++code) {
        double compliance = Transient::largest * code / codes;
        if (double fitness = transient.fitness(compliance, window); fitness > greatest) {
            greatest = fitness;
            best = compliance;
        }
    }
    return best;
}

/// Returns the absolute errors of the compliances, in percent of the right values.
std::vector<double> percent_missed(std::span<const double> compliances, std::span<const double> right) {
    std::vector<double> missed;
    for (std::size_t i = 0; i < compliances.size(); ++i)
        missed.push_back(100 * std::abs(compliances[i] / right[i] - 1));
    return missed;
}

void print_head() {
    fmt::print("{:57}{:^25}{:^20}{:^18}\n", "", "error evaluations", "error, %", "from optimum, %");
    fmt::print("{:<28}{:>14}{:>14}{:>14}{:>10}{:>11}{:>9}{:>10}{:>8}\n", "", "generations/s", "ms/transient", "in each",
               "ns*", "median", "P90", "median", "P90");
}

void print(const Result& result, std::span<const Transient> transients, std::span<const double> optima) {
    std::vector<double> truth(transients.size(), single_boom_mechanics().inlet_compliance_in3_per_psi);
    auto errors = percent_missed(result.compliances, truth), distances = percent_missed(result.compliances, optima);
    std::size_t generations = 0;
    for (const Transient& transient : transients)
        generations += transient.windows() * Transient::trials;
    auto count = static_cast<double>(transients.size()), evaluations = static_cast<double>(result.error_evaluations);
    bool counted = result.error_evaluations > 0;
    fmt::print("{:<28}{:>14.0f}{:>14.3f}{:>14}{:>10}{:>11.2f}{:>9.2f}{:>10.2f}{:>8.2f}\n", result.contestant.name,
               static_cast<double>(generations) / result.seconds, 1e3 * result.seconds / count,
               counted ? fmt::format("{:.0f}", evaluations / count) : "**",
               counted ? fmt::format("{:.1f}", 1e9 * result.seconds / evaluations) : "", lower_median(errors),
               quantile(errors, 0.9), lower_median(distances), quantile(distances, 0.9));
}

/// Returns the time of one error evaluation, in ns: the shortest of several measurements. `evaluate` computes the
/// fitness of a population.
template <typename Evaluate>
double nanoseconds_of(std::size_t evaluations, int goes, Evaluate evaluate) {
    double fastest = std::numeric_limits<double>::infinity();
    for (int go = 0; go < goes; ++go) {
        constexpr int times = 100;
        double start = processor_seconds();
        for (int i = 0; i < times; ++i)
            evaluate();
        fastest = std::min(fastest, (processor_seconds() - start) / times);
    }
    return 1e9 * fastest / static_cast<double>(evaluations);
}

/// Prints the time of an error evaluation alone and vectorised. Returns whether both give the same bits.
bool time_evaluations(const Transient& transient, int goes) {
    auto problem = make_search_problem(CircuitProblem(boom_circuit(), transient.flow));
    RandomStream random(1, "evaluations");
    auto population = random_population(Transient::population, problem->bits(), random);
    std::vector<Sample> window;
    for (const LinkSample& each : transient.window_at(transient.windows() - 1))
        window.push_back(
            {each.inlet_psi, each.inlet_slope_psi_per_s, each.piston_flow_in3_per_s, each.inlet_in2, each.bypass_in2});
    std::vector<double> alone(population.size()), together(population.size());
    std::size_t evaluations = population.size() * window.size();
    double one_by_one = nanoseconds_of(evaluations, goes, [&] {
        for (std::size_t i = 0; i < population.size(); ++i)
            alone[i] = problem->fitness(population[i], window, Transient::bias);
    });
    double vectorised =
        nanoseconds_of(evaluations, goes, [&] { problem->fitness_of(population, window, Transient::bias, together); });
    fmt::print("one error evaluation: {:.2f} ns one by one, {:.2f} ns vectorised ({} doubles at once)\n\n", one_by_one,
               vectorised, vector_width());
    return alone == together;
}

std::vector<Result> contest(std::span<const Transient> transients, int rounds) {
    std::vector<Result> results;
    for (const auto& group : {ours(), galib(), pagmo()})
        for (const Contestant& contestant : group)
            results.push_back({contestant, std::numeric_limits<double>::infinity(), 0, {}});
    for (int round = 0; round < rounds;
         ++round) // the contestants take turns, so that other load on the machine affects all of them
        for (Result& result : results)
            result.run(transients);
    return results;
}

/// Returns the first result with the algorithm of `result` (Contestant::way).
const Result& first_of_way(std::span<const Result> results, const Result& result) {
    return *std::ranges::find_if(results,
                                 [&](const Result& each) { return each.contestant.way == result.contestant.way; });
}

/// Returns whether all contestants that use the same algorithm have the same answers.
bool agree(std::span<const Result> ours) {
    return std::ranges::all_of(
        ours, [&](const Result& each) { return each.compliances == first_of_way(ours, each).compliances; });
}

/// Returns a fingerprint that contains each algorithm once, since the number of vector widths depends on the processor.
std::uint64_t fingerprint(std::span<const Result> ours) {
    Fingerprint all;
    for (const Result& result : ours)
        if (&result == &first_of_way(ours, result))
            for (double compliance : result.compliances)
                all.mix(std::bit_cast<std::uint64_t>(compliance));
    return all.value();
}

} // namespace

int main(int argc, char** argv) {
    long seeds = argc > 1 ? std::strtol(argv[1], nullptr, 10) : 50;
    if (argc > 2 || seeds < 1) {
        fmt::print(stderr, "usage: identification [SEEDS, at least 1]\n");
        return 1;
    }
    const int rounds = seeds < 10 ? 1 : 5;
    std::vector<Transient> transients;
    for (long seed = 1; seed <= seeds; ++seed)
        transients.push_back(transient_of(static_cast<std::uint64_t>(seed)));
    fmt::print(
        "The boom's compliance from a transient of 0.4 s: {} samples, {} generations of {}, window {}; {} seeds\n",
        transients.front().record.size(), transients.front().windows() * Transient::trials, Transient::population,
        Transient::window, seeds);
    bool same_bits = time_evaluations(transients.front(), 20 * rounds);

    auto results = contest(transients, rounds);
    std::vector<double> optima;
    for (const Transient& transient : transients)
        optima.push_back(optimum(transient));
    print_head();
    for (const Result& result : results)
        print(result, transients, optima);
    fmt::print("* time of a transient, divided by its number of error evaluations. The optimum is for the last window; "
               "codes of 10 "
               "bits are {:.2f} % apart.\n"
               "** a string that was evaluated for the same window is not evaluated again.\n",
               100 * Transient::largest / 1024 / single_boom_mechanics().inlet_compliance_in3_per_psi);
    for (auto [rival, missing] : {std::pair("GAlib", galib().empty()), std::pair("pagmo", pagmo().empty())})
        if (missing)
            fmt::print("{} is missing: fetch it by tools/rivals.sh, then configure again\n", rival);
    const auto own = std::span<const Result>(results).first(ours().size());
    same_bits = same_bits && agree(own);
    fmt::print("fingerprint {:016x}\n", fingerprint(own));
    if (!same_bits)
        fmt::print(stderr, "error: contestants with the same algorithm gave different answers, but must give the same "
                           "bits\n");
    return same_bits ? 0 : 1;
}
