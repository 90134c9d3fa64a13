#include "experiments/kit/bootstrap.hpp"
#include "experiments/kit/experiment.hpp"
#include "experiments/kit/seed_runs.hpp"
#include "gaprocs/schema_theorem.hpp"
#include "gaprocs/search.hpp"
#include "text/interval.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace placedpar {

namespace {

constexpr std::size_t schema_bits = 8, schema_population = 50, schema_generations = 10;
constexpr double schema_crossover = 0.8, schema_mutation = 0.01;
constexpr double least_of_bound = 0.99; ///< the claim is that at least this share of the bound is counted

/// The counts for one class of schemata in one run: the lower bound of equation 6.2, the number expected from
/// reproduction alone, and the actual number.
struct SchemaCounts {
    double bound = 0, reproduced = 0, counted = 0;
    double outcomes = 0, below = 0; ///< number of single counts, and number of single counts below the bound

    void add(double expected, double selected, double came) {
        bound += expected;
        reproduced += selected;
        counted += came;
        ++outcomes;
        below += came < expected;
    }
};

/// The class of a schema in a generation, by the mean fitness of its strings. Each string matches exactly one of the
/// schemata with the same fixed positions, so all these schemata together always have as many strings as the
/// population. So the effect of a generation is visible only if fit and unfit schemata are counted separately.
enum class SchemaFit : unsigned char { above, below }; ///< relative to the mean fitness of the population

/// The counts of schemata above the mean come first: order 1 at index 0, and order 2 at the index of the defining
/// length. The counts of schemata below the mean follow in the same order.
using CountsByClass = std::vector<SchemaCounts>;

std::size_t class_of(std::size_t defining_length, SchemaFit fit) {
    return defining_length + (fit == SchemaFit::above ? 0 : schema_bits);
}

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

/// The number of strings of a schema before a generation, and the numbers expected after it.
struct SchemaBefore {
    double strings, reproduced, bound;
};

SchemaBefore look_before(const Schema& schema, const Search& search, const std::vector<double>& fitness,
                         const SearchSettings& settings) {
    return {static_cast<double>(count_matches(schema, search.population())),
            schema_bound(schema, search.population(), fitness, 0, 0),
            schema_bound(schema, search.population(), fitness, settings.crossover_probability,
                         settings.mutation_probability)};
}

/// Makes a generation of a run on f(x) = x^2, and counts the strings of the schemata before and after this generation.
void count_generation(Search& search, const SearchSettings& settings, const std::vector<Schema>& schemata,
                      CountsByClass& counts) {
    std::vector<double> fitness;
    std::vector<SchemaBefore> before;
    for (const Genome& genome : search.population())
        fitness.push_back(square_of(genome));
    for (const Schema& schema : schemata)
        before.push_back(look_before(schema, search, fitness, settings));
    search.next_generation(fitness);
    for (std::size_t i = 0; i < schemata.size(); ++i) {
        if (before[i].bound <= 0)
            continue;
        SchemaFit fit = before[i].reproduced > before[i].strings ? SchemaFit::above : SchemaFit::below;
        counts[class_of(schemata[i].defining_length(), fit)].add(
            before[i].bound, before[i].reproduced,
            static_cast<double>(count_matches(schemata[i], search.population())));
    }
}

/// Returns five figures for each class.
Figures count_run(const SearchSettings& settings, std::uint64_t seed) {
    CountsByClass counts(2 * schema_bits);
    std::vector<Schema> schemata = counted_schemata();
    Search search(schema_bits, settings, RandomStream(seed, "schemata"));
    for (std::size_t generation = 0; generation < schema_generations; ++generation)
        count_generation(search, settings, schemata, counts);
    Figures figures;
    for (const SchemaCounts& each : counts)
        for (double figure : {each.bound, each.reproduced, each.counted, each.outcomes, each.below})
            figures.push_back(figure);
    return figures;
}

enum CountedFigure : std::size_t { bound, reproduced, counted_strings, outcomes, below_bound, figures_of_class };

/// A way of breeding and its runs.
struct SchemaStudy {
    const char* name;
    std::vector<Figures> runs;

    std::vector<double> figures(std::size_t length, SchemaFit fit, CountedFigure figure) const {
        return column(runs, figures_of_class * class_of(length, fit) + figure);
    }
    double sum(std::size_t length, SchemaFit fit, CountedFigure figure) const {
        std::vector<double> all = figures(length, fit, figure);
        return std::accumulate(all.begin(), all.end(), 0.0);
    }
    double quotient(std::size_t length, SchemaFit fit, CountedFigure above, CountedFigure under) const {
        return sum(length, fit, above) / sum(length, fit, under);
    }
    Interval interval(std::size_t length, SchemaFit fit, CountedFigure above, CountedFigure under) const {
        return quotient_interval(figures(length, fit, above), figures(length, fit, under));
    }
};

SchemaStudy study_schemata(const ReplayContext& context, const char* name, double crossover, double mutation) {
    SearchSettings settings;
    settings.population = schema_population;
    settings.crossover_probability = crossover;
    settings.mutation_probability = mutation;
    return {name, run_seeds(context, name, [&](std::uint64_t seed) { return count_run(settings, seed); })};
}

std::string length_row(std::size_t length) {
    return length == 0 ? "order 1" : fmt::format("order 2, defining length {}", length);
}

/// Adds the counts divided by their bounds. The upper end of the quotient's 95 % interval must be at least
/// `least_of_bound`.
void add_bounds(Comparison& comparison, const SchemaStudy& study, SchemaFit fit) {
    std::string name = study.name;
    for (std::size_t length = 0; length < schema_bits; ++length) {
        Interval interval = study.interval(length, fit, counted_strings, bound);
        std::string row = length_row(length);
        comparison.add(plain_cell(row, name, "", study.quotient(length, fit, counted_strings, bound), 3));
        comparison.add(at_least(least_of_bound, plain_cell(row, name + " <=", "", interval.high, 3)));
    }
}

Comparison compare_bounds(const std::vector<SchemaStudy>& studies, SchemaFit fit) {
    Comparison comparison{.name = fmt::format("schemata {} the mean fitness: number counted in {} runs of {} "
                                              "generations / least number that equation 6.2 expects",
                                              fit == SchemaFit::above ? "above" : "below", studies.front().runs.size(),
                                              schema_generations),
                          .against = "claim",
                          .judged = true};
    for (const SchemaStudy& study : studies)
        add_bounds(comparison, study, fit);
    return comparison;
}

/// Compares the runs with claims that say more than the bound. Each claim is expressed as a number.
Comparison compare_claims(const SchemaStudy& crossed, const SchemaStudy& uncrossed) {
    Comparison comparison{.name = "claims about schemata above the mean fitness", .against = "claim", .judged = true};
    double most = 0;
    for (std::size_t length = 0; length < schema_bits; ++length)
        most = std::max(most, uncrossed.quotient(length, SchemaFit::above, counted_strings, bound));
    constexpr std::size_t longest = schema_bits - 1;
    comparison.add(at_most(1.05, plain_cell("without crossover, the most over its bound", "found", "", most, 3)));
    comparison.add(at_least(2, plain_cell("with crossover, defining length 7 over its bound", "found", "",
                                          crossed.quotient(longest, SchemaFit::above, counted_strings, bound), 3)));
    comparison.add(compared_cell("survivors of defining length 7 / those of 1, claimed .9 at most", "found", "", 0.9,
                                 crossed.quotient(longest, SchemaFit::above, counted_strings, reproduced) /
                                     crossed.quotient(1, SchemaFit::above, counted_strings, reproduced),
                                 3));
    return comparison;
}

/// Divides the number of strings of fit schemata, after crossover and mutation, by the number expected from
/// reproduction alone. The reference is the quotient that equation 6.2 guarantees.
Comparison compare_survival(const SchemaStudy& study) {
    Comparison comparison{.name = "schemata above the mean fitness: number counted / number from reproduction alone",
                          .against = "eq. 6.2"};
    for (std::size_t length = 0; length < schema_bits; ++length) {
        std::string row = length_row(length), name = study.name;
        Interval interval = study.interval(length, SchemaFit::above, counted_strings, reproduced);
        comparison.add(compared_cell(row, name, "", study.quotient(length, SchemaFit::above, bound, reproduced),
                                     study.quotient(length, SchemaFit::above, counted_strings, reproduced), 3));
        comparison.add(plain_cell(row, name + " >=", "", interval.low, 3));
        comparison.add(plain_cell(row, name + " <=", "", interval.high, 3));
        comparison.add(plain_cell(row, "single counts below [%]", "",
                                  100 * study.quotient(length, SchemaFit::above, below_bound, outcomes), 0));
    }
    return comparison;
}

/// Returns a curve that shows the quotients against the defining length, with their intervals.
Series quotients(const SchemaStudy& study, CountedFigure under) {
    Series series{.name = study.name};
    for (std::size_t length = 1; length < schema_bits; ++length) {
        series.points.push_back(
            {static_cast<double>(length), study.quotient(length, SchemaFit::above, counted_strings, under)});
        series.intervals.push_back(study.interval(length, SchemaFit::above, counted_strings, under));
    }
    return series;
}

Panel schemata_panel(const std::vector<SchemaStudy>& studies, CountedFigure under, std::string title, Axis y) {
    Panel panel{.title = std::move(title), .x = {"defining length", 1, 7}, .y = std::move(y)};
    for (const SchemaStudy& study : studies)
        panel.series.push_back(quotients(study, under));
    return panel;
}

Replay replay_schemata(const ReplayContext& context) {
    std::vector<SchemaStudy> studies{study_schemata(context, "rates .8 and .01", schema_crossover, schema_mutation),
                                     study_schemata(context, "no crossover", 0, schema_mutation),
                                     study_schemata(context, "reproduction alone", 0, 0)};
    Panel bounds = schemata_panel(studies, bound, "schemata of order 2 above the mean fitness",
                                  {"counted / bound", 0, std::nullopt});
    bounds.marks = {{"the bound", 1}};
    Panel survival =
        schemata_panel({studies.front()}, reproduced, "schemata of order 2: share that survives crossover and mutation",
                       {"counted / reproduced", 0, 1.2});
    return replay_of({compare_bounds(studies, SchemaFit::above), compare_bounds(studies, SchemaFit::below),
                      compare_survival(studies.front()), compare_claims(studies[0], studies[1])},
                     {{"schemata", {"Equation 6.2 and what comes", {bounds, survival}}}});
}

} // namespace

extern const Experiment schemata_experiment{
    .name = "schemata",
    .about = "schemata counted in runs, compared with the bound of equation 6.2",
    .chapter = "6",
    .number = 2,
    .run = replay_schemata,
    .seeds = 100,
};

} // namespace placedpar
