#include "app/generation/generation_walk.hpp"

#include "gaprocs/policies/crossover.hpp"
#include "gaprocs/policies/mutation.hpp"
#include "gaprocs/policies/reproduction.hpp"
#include "gaprocs/settings.hpp"
#include "text/nearest.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

namespace placedpar {

namespace {

struct WalkFunction {
    const char* name;
    double (*value)(std::uint64_t x);
};

constexpr WalkFunction walk_function_table[]{
    {"square", [](std::uint64_t x) { return static_cast<double>(x * x); }},
    {"ones", [](std::uint64_t x) { return static_cast<double>(std::popcount(x)); }},
    {"impulse", [](std::uint64_t x) { return x == 0b1011 ? 1.0 : 0.0; }},
};

const WalkFunction& walk_function(const std::string& name) {
    auto found = std::ranges::find_if(walk_function_table, [&](const WalkFunction& each) { return each.name == name; });
    if (found == std::end(walk_function_table))
        throw UserError(unknown_name("function", name, walk_functions(),
                                     fmt::format("the functions are {}", fmt::join(walk_functions(), ", "))));
    return *found;
}

WalkSettings validated(const WalkSettings& settings) {
    SearchSettings search;
    search.population = settings.population;
    search.crossover_probability = settings.crossover_probability;
    search.mutation_probability = settings.mutation_probability;
    search.validate();
    walk_function(settings.function);
    return settings;
}

std::vector<Genome> copies_of(const std::vector<Genome>& population, const std::vector<std::size_t>& parents) {
    std::vector<Genome> copies;
    for (std::size_t parent : parents)
        copies.push_back(population[parent]);
    return copies;
}

} // namespace

std::vector<std::string> walk_functions() {
    std::vector<std::string> names;
    for (const WalkFunction& each : walk_function_table)
        names.emplace_back(each.name);
    return names;
}

GenerationWalk::GenerationWalk(const WalkSettings& settings)
    : settings_(validated(settings)), random_(settings.seed, "generation"),
      population_(random_population(settings.population, walk_bits, random_)) {}

WalkedGeneration GenerationWalk::next() {
    WalkedGeneration walked{.number = ++generations_, .population = population_};
    for (const Genome& genome : population_)
        walked.fitness.push_back(walk_function(settings_.function).value(genome.field(0, walk_bits)));
    reproduce(walked);
    if (walked.parents.empty()) { // as in Search, all strings are drawn anew
        walked.mutated = random_population(settings_.population, walk_bits, random_);
    } else {
        cross(walked);
        walked.mutated = walked.crossed;
        BitMutation{settings_.mutation_probability}(walked.mutated, random_);
    }
    population_ = walked.mutated;
    return walked;
}

void GenerationWalk::reproduce(WalkedGeneration& walked) {
    RandomStream again = random_;
    Parents parents = Reproduction()(walked.fitness, settings_.population, random_);
    if (!parents)
        return;
    walked.parents = *parents;
    for (std::size_t i = 0; i < walked.parents.size(); ++i)
        walked.spins.push_back(again.uniform());
    walked.reproduced = copies_of(walked.population, walked.parents);
}

void GenerationWalk::cross(WalkedGeneration& walked) {
    RandomStream again = random_;
    walked.crossed = walked.reproduced;
    Crossover()(walked.crossed, settings_.crossover_probability, BitString(walk_bits), random_);
    for (std::size_t pair = 0; pair < walked.crossed.size() / 2; ++pair) {
        double drawn = again.uniform();
        bool crossed = drawn < settings_.crossover_probability;
        walked.matings.push_back({drawn, crossed, crossed ? 1 + again.below(walk_bits - 1) : 0});
    }
}

} // namespace placedpar
