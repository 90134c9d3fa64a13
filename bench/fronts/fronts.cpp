// This program searches for the fronts of ZDT1 to ZDT4 and for the optima of G01 to G06, and prints the result of each
// seed. compare.py compares the results with the results of other programs.
//
// usage: fronts SEEDS FRONT_EVALUATIONS CONSTRAINED_EVALUATIONS

#include "gaprocs/front_search.hpp"
#include "gaprocs/problem_registry.hpp"
#include "problems/benchmark/benchmark.hpp"
#include "runtime/fingerprint.hpp"

#include <bit>
#include <cstdio>
#include <cstdlib>
#include <string>

using namespace placedpar;

namespace {

constexpr std::size_t survivors = 100;

FrontResult search_with(const ProblemRegistry& problems, const std::string& name, std::size_t evaluations,
                        std::uint64_t seed) {
    const auto problem = problems.find(name).problem()->coded(Coding::real);
    const SearchSettings settings = front_settings(problem->representation(), 2 * survivors);
    return search_front(*problem, evaluations / survivors - 1, settings, RandomStream(seed, name));
}

void print(const std::string& name, std::uint64_t seed, const FrontResult& found, Fingerprint& fingerprint) {
    if (found.front.empty())
        std::printf("%s %llu not feasible\n", name.c_str(), static_cast<unsigned long long>(seed));
    for (const FrontIndividual& each : found.front) {
        if (&each != &found.front.front() && each.objectives.size() == 1)
            break; // the other individuals have the same value
        std::printf("%s %llu", name.c_str(), static_cast<unsigned long long>(seed));
        for (double value : each.objectives) {
            std::printf(" %.17g", value);
            fingerprint.mix(std::bit_cast<std::uint64_t>(value));
        }
        std::printf("\n");
    }
}

} // namespace

int main(int count, char** argument) {
    const auto number = [&](int i) { return count == 4 ? std::strtoul(argument[i], nullptr, 10) : 0; };
    if (number(1) < 1 || number(2) < 2 * survivors || number(3) < 2 * survivors) {
        std::fprintf(stderr, "usage: fronts SEEDS FRONT_EVALUATIONS CONSTRAINED_EVALUATIONS, at least 200\n");
        return 1;
    }
    ProblemRegistry problems;
    add_benchmark_problems(problems);
    Fingerprint fingerprint;
    for (const char* name : {"zdt1", "zdt2", "zdt3", "zdt4", "g01", "g02", "g03", "g04", "g05", "g06"})
        for (std::uint64_t seed = 1; seed <= number(1); ++seed)
            print(name, seed, search_with(problems, name, number(*name == 'z' ? 2 : 3), seed), fingerprint);
    std::fprintf(stderr, "fingerprint %016llx\n", static_cast<unsigned long long>(fingerprint.value()));
}
