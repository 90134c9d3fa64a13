// This program compares native processor times for each sample of chapter 5's plant: a genetic algorithm of 100
// individuals against recursive least squares with all four delays.
//
// usage: recursion [SEEDS]

#include "bench/measure.hpp"
#include "experiments/chapter_5/kit/least_squares.hpp"
#include "gaprocs/traditional.hpp"
#include "problems/plant/plant_problem.hpp"
#include "runtime/fingerprint.hpp"
#include "runtime/random.hpp"
#include "text/statistics.hpp"

#include <bit>

using namespace placedpar;

namespace {

using Record = std::vector<Sample>;

double search_ns(const Record& record, std::size_t window, std::size_t trials, std::uint64_t seed, Fingerprint& all) {
    SearchSettings settings;
    settings.population = 100;
    settings.elite = 1;
    settings.reproduction = UniversalReproduction{};
    settings.window = {window, window, trials, 10};
    auto problem = make_search_problem(PlantProblem());
    bench::Stopwatch watch;
    SearchResult result = run_traditional(*problem, record, settings, RandomStream(seed, "search"));
    double taken = watch.nanoseconds();
    all.mix(std::bit_cast<std::uint64_t>(result.estimates.back().parameters[1]));
    return taken / static_cast<double>(result.estimates.size());
}

double recursion_ns(const Record& record, Fingerprint& all) {
    constexpr int times = 20; // one record takes too short a time to be measured
    bench::Stopwatch watch;
    for (int i = 0; i < times; ++i)
        for (std::size_t delay = 1; delay <= LinearPlant::delays; ++delay) {
            RecursiveEstimate<double> estimate(LinearPlant::coefficients);
            double squared_error = 0;
            for (const Sample& sample : record) {
                const double* input = &sample[2 + delay];
                std::array<double, LinearPlant::coefficients> inputs{sample[1], sample[2], input[0], input[1],
                                                                     input[2]};
                double error = estimate.take(inputs, sample[0], 0.9);
                squared_error = 0.9 * squared_error + error * error;
            }
            all.mix(std::bit_cast<std::uint64_t>(squared_error));
        }
    return watch.nanoseconds() / times / static_cast<double>(record.size());
}

void compare(std::size_t window, std::size_t trials, long seeds, Fingerprint& all) {
    std::vector<double> searches, recursions, quotients;
    for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(seeds); ++seed) {
        Record record = plant_record({.per_sample = trials}, RandomStream(seed, "plant"));
        searches.push_back(search_ns(record, window, trials, seed, all));
        recursions.push_back(recursion_ns(record, all));
        quotients.push_back(searches.back() / recursions.back());
    }
    fmt::print("window {}, generations a sample {}: search {:7.1f} us, recursion {:5.2f} us, ratio {:5.1f} (95 % of "
               "seeds: {:.1f} "
               "to {:.1f})\n",
               window, trials, 1e-3 * median(searches), 1e-3 * median(recursions), median(quotients),
               quantile(quotients, 0.025), quantile(quotients, 0.975));
}

} // namespace

int main(int argc, char** argv) {
    long seeds = bench::argument(argc, argv, 1, 60, "recursion [SEEDS]");
    Fingerprint all;
    for (std::size_t trials : {1u, 3u})
        for (std::size_t window : {10u, 30u})
            compare(window, trials, seeds, all);
    fmt::print("fingerprint {:016x}\n", all.value());
}
