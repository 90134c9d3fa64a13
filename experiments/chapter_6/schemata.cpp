#include "experiments/kit/experiment.hpp"
#include "experiments/kit/record_seeds.hpp"
#include "gaprocs/schema_theorem.hpp"
#include "gaprocs/search.hpp"

#include <fmt/format.h>

namespace placedpar {

namespace {

constexpr std::size_t schema_bits = 8, schema_population = 50, schema_generations = 10, schema_runs = 100;

/// What equation 6.2 said of some schemata, and what came.
struct SchemaCounts {
    double bound = 0, measured = 0;
    std::size_t outcomes = 0, below = 0; ///< single counts, and those that were less than the bound

    void add(double expected, double counted) {
        if (expected <= 0)
            return;
        bound += expected;
        measured += counted;
        ++outcomes;
        below += counted < expected;
    }
    double ratio() const { return measured / bound; }
    double below_percent() const { return 100 * static_cast<double>(below) / static_cast<double>(outcomes); }
};

/// By defining length, of order 2; and of order 1, at 0.
using CountsByLength = std::vector<SchemaCounts>;

std::vector<Schema> counted_schemata() {
    std::vector<Schema> schemata = schemata_of_order(schema_bits, 1);
    std::vector<Schema> pairs = schemata_of_order(schema_bits, 2);
    schemata.insert(schemata.end(), pairs.begin(), pairs.end());
    return schemata;
}

double square_of(const Genome& genome) {
    auto x = static_cast<double>(genome.field(0, schema_bits));
    return x * x;
}

/// A generation of a run on f(x) = x^2.
void count_generation(Search& search, const SearchSettings& settings, const std::vector<Schema>& schemata,
                      CountsByLength& counts) {
    std::vector<double> fitness, bounds;
    for (const Genome& genome : search.population())
        fitness.push_back(square_of(genome));
    for (const Schema& schema : schemata)
        bounds.push_back(schema_bound(schema, search.population(), fitness, settings.crossover_probability,
                                      settings.mutation_probability));
    search.next_generation(fitness);
    for (std::size_t i = 0; i < schemata.size(); ++i)
        counts[schemata[i].defining_length()].add(bounds[i],
                                                  static_cast<double>(count_matches(schemata[i], search.population())));
}

CountsByLength count_runs(const SearchSettings& settings, const ReplayContext& context, const char* what) {
    CountsByLength counts(schema_bits);
    std::vector<Schema> schemata = counted_schemata();
    context.progress(what);
    for (std::uint64_t seed : record_seeds(context.seed, schema_runs)) {
        Search search(schema_bits, settings, RandomStream(seed, "schemata"));
        for (std::size_t generation = 0; generation < schema_generations; ++generation)
            count_generation(search, settings, schemata, counts);
    }
    return counts;
}

SearchSettings schema_settings(double crossover_probability, double mutation_probability) {
    SearchSettings settings;
    settings.population = schema_population;
    settings.crossover_probability = crossover_probability;
    settings.mutation_probability = mutation_probability;
    return settings;
}

std::string length_row(std::size_t length) {
    return length == 0 ? "order 1" : fmt::format("order 2, defining length {}", length);
}

/// The measured counts over their bounds, in two columns.
void add_counts(Comparison& comparison, const char* column, const CountsByLength& counts, bool equality) {
    for (std::size_t length = 0; length < counts.size(); ++length) {
        std::string row = length_row(length);
        Cell ratio = equality ? judged_cell(row, column, "", 1, counts[length].ratio(), 0.02, 3)
                              : at_least(0.99, plain_cell(row, column, "", counts[length].ratio(), 3));
        comparison.add(ratio);
    }
}

void add_single_outcomes(Comparison& comparison, const CountsByLength& counts) {
    for (std::size_t length = 0; length < counts.size(); ++length)
        comparison.add(
            plain_cell(length_row(length), "single counts below [%]", "", counts[length].below_percent(), 0));
}

Series ratios(const char* name, const CountsByLength& counts) {
    Series series{name};
    for (std::size_t length = 1; length < counts.size(); ++length)
        series.points.push_back({static_cast<double>(length), counts[length].ratio()});
    return series;
}

Replay replay_schemata(const ReplayContext& context) {
    CountsByLength all = count_runs(schema_settings(0.8, 0.01), context, "crossover .8, mutation .01"),
                   no_crossover = count_runs(schema_settings(0, 0.01), context, "no crossover"),
                   selection = count_runs(schema_settings(0, 0), context, "reproduction alone");
    Comparison comparison{.name = fmt::format("schemata counted in {} runs of {} generations, over what equation 6.2 "
                                              "expects at least",
                                              schema_runs, schema_generations),
                          .against = "known"};
    add_counts(comparison, "rates .8 and .01", all, false);
    add_counts(comparison, "no crossover", no_crossover, false);
    add_counts(comparison, "reproduction alone", selection, true);
    add_single_outcomes(comparison, all);
    Panel panel{.title = "strings counted over strings expected at least, schemata of order 2",
                .x = {"defining length", 1, 7},
                .y = {"counted / bound", 0, std::nullopt},
                .series = {ratios("rates .8 and .01", all), ratios("no crossover", no_crossover),
                           ratios("reproduction alone", selection)},
                .marks = {{"the bound", 1}}};
    return replay_of({comparison}, {{"schemata", {"Equation 6.2 and what comes", {panel}}}});
}

} // namespace

extern const Experiment schemata_experiment{
    .name = "schemata",
    .about = "schemata counted in runs, beside the bound of equation 6.2",
    .chapter = "6",
    .number = 2,
    .run = replay_schemata,
};

} // namespace placedpar
