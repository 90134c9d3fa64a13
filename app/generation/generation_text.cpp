#include "app/generation/generation_walk.hpp"
#include "gaprocs/representation/schema.hpp"
#include "gaprocs/schema_theorem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace placedpar {

namespace {

double sum_of(const std::vector<double>& fitness) { return std::accumulate(fitness.begin(), fitness.end(), 0.0); }

/// Prints the table of step 0. The strings are numbered from 1.
std::string evaluation_text(const WalkedGeneration& walked) {
    double sum = sum_of(walked.fitness), from = 0;
    std::string out = "step 0: fitness, and the sectors of the roulette wheel\n"
                      "  no.  string   x  fitness   share  sector          expected copies\n";
    for (std::size_t i = 0; i < walked.population.size(); ++i) {
        double share = sum > 0 ? walked.fitness[i] / sum : 0;
        out +=
            fmt::format("  {:3}  {:6}  {:2}  {:7}  {:6.3f}  {:.3f} to {:.3f}  {:15.2f}\n", i + 1,
                        walked.population[i].to_string(), walked.population[i].field(0, walk_bits), walked.fitness[i],
                        share, from, from + share, share * static_cast<double>(walked.population.size()));
        from += share;
    }
    return out + fmt::format("  sum {}, mean {:.2f}, best {}\n", sum,
                             sum / static_cast<double>(walked.population.size()), std::ranges::max(walked.fitness));
}

std::string reproduction_text(const WalkedGeneration& walked) {
    if (walked.parents.empty())
        return "step 1: every sector has width 0, so the whole population is drawn at random\n";
    std::string out = "step 1: reproduction, a spin of the wheel for each mate\n   mate   spin  in sector  copy\n";
    for (std::size_t i = 0; i < walked.parents.size(); ++i)
        out += fmt::format("  {:5}  {:.3f}  {:9}  {}\n", i + 1, walked.spins[i], walked.parents[i] + 1,
                           walked.reproduced[i].to_string());
    return out;
}

std::string cut_in_two(const Genome& genome, std::size_t cut) {
    std::string text = genome.to_string();
    return text.substr(0, cut) + "|" + text.substr(cut);
}

std::string mating_text(const WalkedGeneration& walked, std::size_t pair) {
    const Mating& mating = walked.matings[pair];
    const Genome &a = walked.reproduced[2 * pair], &b = walked.reproduced[2 * pair + 1];
    std::string out = fmt::format("  {} and {}  {:.3f}  ", 2 * pair + 1, 2 * pair + 2, mating.drawn);
    if (!mating.crossed)
        return out + fmt::format("not crossed: {}, {}\n", a.to_string(), b.to_string());
    return out + fmt::format("{} x {}  ->  {}, {}   (differing bits: {})\n", cut_in_two(a, mating.cut),
                             cut_in_two(b, mating.cut), walked.crossed[2 * pair].to_string(),
                             walked.crossed[2 * pair + 1].to_string(), difference(a, b));
}

std::string crossover_text(const WalkedGeneration& walked, const WalkSettings& settings) {
    std::string out = fmt::format("step 2: crossover of neighbours if the number drawn is below {}; the mates "
                                  "swap the characters before the cut\n  mates    drawn\n",
                                  settings.crossover_probability);
    for (std::size_t pair = 0; pair < walked.matings.size(); ++pair)
        out += mating_text(walked, pair);
    return out;
}

std::string mutation_text(const WalkedGeneration& walked, const WalkSettings& settings) {
    std::string flips;
    for (std::size_t i = 0; i < walked.mutated.size(); ++i)
        if (walked.mutated[i] != walked.crossed[i])
            flips += fmt::format("  string {}: {} -> {}\n", i + 1, walked.crossed[i].to_string(),
                                 walked.mutated[i].to_string());
    return fmt::format("step 3: mutation, each bit with probability {}\n{}", settings.mutation_probability,
                       flips.empty() ? "  no bit was flipped\n" : flips);
}

std::string schemata_text(const WalkedGeneration& walked, const WalkSettings& settings) {
    std::string out =
        "schemata of order 1 (equation 6.2)\n  schema  strings  expected at least  in the next generation\n";
    for (const Schema& schema : schemata_of_order(walk_bits, 1))
        out +=
            fmt::format("  {:6}  {:7}  {:17.2f}  {:22}\n", schema.to_string(), count_matches(schema, walked.population),
                        schema_bound(schema, walked.population, walked.fitness, settings.crossover_probability,
                                     settings.mutation_probability),
                        count_matches(schema, walked.mutated));
    return out;
}

} // namespace

std::string print_walk(const WalkedGeneration& walked, const WalkSettings& settings) {
    std::string out =
        fmt::format("generation {}\n\n{}\n{}\n", walked.number, evaluation_text(walked), reproduction_text(walked));
    if (!walked.parents.empty())
        out += crossover_text(walked, settings) + "\n" + mutation_text(walked, settings) + "\n";
    return out + schemata_text(walked, settings);
}

} // namespace placedpar
