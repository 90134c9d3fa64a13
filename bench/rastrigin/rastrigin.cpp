// This program measures how many evaluations and seconds our genetic algorithms and rivals need to reach 1e-6 on
// Rastrigin's function in 20 dimensions.
//
// usage: rastrigin [SEEDS [EVALUATIONS]]    at most EVALUATIONS evaluations in each run

#include "bench/rastrigin/contest.hpp"
#include "runtime/fingerprint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>

using namespace placedpar;

namespace {

/// Returns the processor time, which other programs on the machine do not affect. No rival uses threads.
double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct Result {
    Contestant contestant;
    std::vector<std::uint64_t> needed; // evaluations of the runs that reached the target
    std::vector<double> seconds;       // processor time of the same runs
    std::uint64_t evaluations = 0;     // evaluations of all runs
    double all_seconds = 0;

    void run(std::uint64_t seed, std::uint64_t most_evaluations) {
        Valley valley(most_evaluations);
        double start = processor_seconds();
        try {
            contestant.descend(valley, seed);
        } catch (const Valley::Stop&) {
        }
        double took = processor_seconds() - start;
        evaluations += valley.evaluations();
        all_seconds += took;
        if (!valley.reached())
            return;
        needed.push_back(valley.evaluations());
        seconds.push_back(took);
    }
};

/// Returns a quantile over all runs. A run that did not reach the target counts as longer than all others.
template <class Number>
std::string quantile(std::vector<Number> reached, std::size_t runs, double share, const char* format) {
    std::sort(reached.begin(), reached.end());
    auto index = static_cast<std::size_t>(share * static_cast<double>(runs - 1));
    return index < reached.size() ? fmt::format(fmt::runtime(format), reached[index]) : "-";
}

void print(const Result& result, std::size_t runs) {
    auto evaluations = [&](double share) { return quantile(result.needed, runs, share, "{}"); };
    fmt::print("{:<31}{:>5} of {:<4}{:>9}{:>9}{:>9}{:>11}{:>9.0f}\n", result.contestant.name, result.needed.size(),
               runs, evaluations(0.1), evaluations(0.5), evaluations(0.9),
               quantile(result.seconds, runs, 0.5, "{:.4f}"),
               1e9 * result.all_seconds / static_cast<double>(result.evaluations));
}

std::vector<Result> contest(std::uint64_t seeds, std::uint64_t most_evaluations) {
    std::vector<Result> results;
    for (const auto& group : {ours(), pagmo()})
        for (const Contestant& contestant : group)
            results.push_back({.contestant = contestant, .needed = {}, .seconds = {}});
    // The contestants take turns, so that other load on the machine affects all of them. A dot is printed after each
    // seed, since the whole contest takes minutes.
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        for (Result& result : results)
            result.run(seed, most_evaluations);
        fmt::print(stderr, ".");
    }
    fmt::print(stderr, "\n");
    return results;
}

/// Returns the fingerprint of our own runs.
std::uint64_t fingerprint_of(const std::vector<Result>& results) {
    Fingerprint all;
    for (std::size_t i = 0; i < ours().size(); ++i)
        for (std::uint64_t needed : results[i].needed)
            all.mix(needed);
    return all.value();
}

long number(int argc, char** argv, int index, long by_default) {
    return argc > index ? std::strtol(argv[index], nullptr, 10) : by_default;
}

} // namespace

int main(int argc, char** argv) {
    long seeds = number(argc, argv, 1, 60), most = number(argc, argv, 2, 1'000'000);
    if (argc > 3 || seeds < 1 || most < 1) {
        fmt::print(stderr, "usage: rastrigin [SEEDS [EVALUATIONS]], each at least 1\n");
        return 1;
    }
    fmt::print("Rastrigin's function in {} dimensions to {}: at most {} evaluations; {} seeds\n\n", Valley::dimensions,
               Valley::target, most, seeds);
    std::fflush(stdout);
    auto results = contest(static_cast<std::uint64_t>(seeds), static_cast<std::uint64_t>(most));
    fmt::print("{:40}{:^30}{:>11}{:>9}\n", "", "evaluations needed", "seconds,", "ns an");
    fmt::print("{:<31}{:>9}{:>12}{:>9}{:>9}{:>10}{:>12}\n", "", "reached", "P10", "median", "P90", "median",
               "evaluation");
    for (const Result& result : results)
        print(result, static_cast<std::size_t>(seeds));
    if (pagmo().empty())
        fmt::print("pagmo is missing: fetch it by tools/rivals.sh, then configure again\n");
    fmt::print("fingerprint {:016x}\n", fingerprint_of(results));
}
