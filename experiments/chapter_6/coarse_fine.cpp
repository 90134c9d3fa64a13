#include "experiments/chapter_6/kit/conditions.hpp"
#include "experiments/chapter_6/kit/landscape.hpp"
#include "experiments/chapter_6/kit/pair_picture.hpp"
#include "experiments/kit/claims.hpp"

#include <fmt/format.h>

#include <algorithm>

#include <array>
#include <cmath>

namespace placedpar {

namespace {

constexpr std::array coarse_populations{24, 30, 50};

/// A row of Table 6.4, or a row with the conventional string of 37 bits, which is the control.
struct CoarseRow {
    std::size_t field_bits; ///< bits of each of the five parameters
    std::size_t population;
    const char* thesis;
    Expected with_elite, to_the_letter;
};

constexpr const char* failed = "failed to converge";

const CoarseRow coarse_rows[]{
    {4, 24, failed, {90, 38}, {30, 0}},       {4, 30, failed, {94, 51}, {31, 0}},
    {4, 50, failed, {100, 76}, {40, 0}},      {5, 24, "good (converge rapidly)", {97, 42}, {26, 0}},
    {5, 30, failed, {97, 48}, {31, 0}},       {5, 50, "slow convergence rate", {99, 82}, {41, 0}},
    {7, 24, "not tried", {97, 55}, {31, 0}},  {7, 30, "not tried", {99, 66}, {38, 0}},
    {7, 50, "not tried", {100, 80}, {45, 0}},
};

std::size_t string_bits(std::size_t field_bits) { return plant_reading(field_bits).length(); }

SearchSettings letter_settings(std::size_t population) {
    SearchSettings settings = plant_settings(population);
    settings.reproduction = RouletteReproduction();
    settings.elite = 0;
    return settings;
}

struct CoarseTable {
    Comparison comparison;
    std::vector<Tally> tallies;
};

CoarseTable coarse_table(const ReplayContext& context, const std::string& name, SearchSettings (*settings)(std::size_t),
                         Expected CoarseRow::*expected) {
    CoarseTable table{{.name = "Table 6.4 over many seeds, " + name, .against = "other", .judged = true}, {}};
    for (const CoarseRow& row : coarse_rows) {
        std::string title =
            fmt::format("{} bits, {} individuals, {}", string_bits(row.field_bits), row.population, name);
        table.tallies.push_back(
            tally_search(context, title, {settings(row.population), plant_reading(row.field_bits)}));
        table.tallies.back().name =
            fmt::format("{} bits, {} ({})", string_bits(row.field_bits), row.population, row.thesis);
        add_tally(table.comparison, table.tallies.back(), row.*expected);
    }
    table.comparison.notes =
        "other: figures of this program with 60 or 100 other seeds; in parentheses: what the thesis says\n";
    return table;
}

/// Returns the settings of a pair of a coarse and a fine search. Each search has this population, and this number of
/// bits for each of the five parameters.
CoarseFineSettings pair_settings(std::size_t population, std::size_t field_bits) {
    Recoding coarse = plant_reading(field_bits);
    return {plant_settings(population), plant_settings(population), coarse, coarse.bits};
}

/// Compares pairs with single searches. The population of a single search is as large as both populations of a pair
/// together.
Comparison pair_table(const ReplayContext& context) {
    Comparison comparison{.name =
                              "the pair (answer of the fine search), and single searches with equally many evaluations",
                          .against = "other",
                          .judged = true};
    const std::array<std::array<Expected, 3>, 2> expected{
        {{{{98, 76}, {100, 88}, {100, 91}}}, {{{100, 95}, {100, 96}, {100, 100}}}}};
    for (std::size_t i = 0; i < coarse_populations.size(); ++i) {
        auto population = static_cast<std::size_t>(coarse_populations[i]);
        std::vector<Tally> pairs;
        for (std::size_t bits : {std::size_t{4}, std::size_t{5}}) {
            CoarseFineSettings settings = pair_settings(population, bits);
            pairs.push_back(
                tally_runs(context, fmt::format("pair of {} bits, {} + {}", string_bits(bits), population, population),
                           [&](std::uint64_t seed) { return run_plant_pair(settings, seed).fine; }));
            add_tally(comparison, pairs.back(), expected[bits - 4][i]);
        }
        Tally single = tally_search(context, fmt::format("single, 37 bits, {}", 2 * population),
                                    {plant_settings(2 * population), plant_reading(7)});
        add_tally(comparison, single);
    }
    return comparison;
}

double impulse_percent(std::size_t bits) {
    return 100 * (1 + static_cast<double>(bits)) / std::exp2(static_cast<double>(bits));
}

void add_landscape(Comparison& comparison, const std::string& column, const LandscapeFacts& facts) {
    comparison.add(plain_cell("strings of positive fitness", column, "%", facts.fit_percent, 3));
    comparison.add(plain_cell("strings within .1 of the pole", column, "", facts.good_strings, 0));
    comparison.add(plain_cell("strings without a better neighbour", column, "", static_cast<double>(facts.minima), 0));
    comparison.add(at_least(0.1, compared_cell("descents that end at the optimum", column, "%", impulse_percent(22),
                                               facts.optimum_percent, 4)));
    comparison.add(
        at_least(5, plain_cell("descents that end within .1 of the pole", column, "%", facts.good_percent, 2)));
    comparison.add(
        at_least(0.1, compared_cell("correlation of error and bit difference", column, "", 0, facts.correlation, 3)));
}

Comparison landscape_table(const ReplayContext& context) {
    Comparison comparison{.name =
                              "is it an impulse? all 4 194 304 strings of 22 bits, steepest one-bit descent from each",
                          .against = "impulse",
                          .judged = true};
    for (Coding coding : {Coding::natural, Coding::gray}) {
        context.progress(fmt::format("all strings of 22 bits, {} code", coding.text()));
        add_landscape(comparison, coding.text(),
                      enumerate_landscape(plant_reading(4, coding), seeds_of(context).front()));
    }
    return comparison;
}

/// Tests the thesis's claim "more than two or three thousands" (6.2). Counts how many of the strings that differ only
/// in the 15 "don't care" bits have nearly the best fitness.
Comparison near_optimum_claims(const ReplayContext& context) {
    constexpr double percents[]{99, 95};
    std::vector<Claim> claims;
    for (double noise : {0.0, 0.3}) {
        auto runs = run_seeds(context, fmt::format("don't-care bits, sigma = {}", noise), [=](std::uint64_t seed) {
            auto fitness = fitness_by_low_bits(noise, seed);
            const double best = std::ranges::max(fitness);
            Figures counts;
            for (double percent : percents)
                counts.push_back(static_cast<double>(
                    std::ranges::count_if(fitness, [=](double each) { return each >= percent / 100 * best; })));
            return counts;
        });
        for (std::size_t i = 0; i < std::size(percents); ++i)
            claims.push_back({fmt::format("at least {} % of the best fitness, sigma = {}", percents[i], noise),
                              "strings",
                              column(runs, i),
                              3000,
                              {}});
    }
    return claims_comparison("of the 32 768 strings that differ from the plant's in don't-care bits", claims);
}

Panel table_6_4_panel(const std::string& title, const std::vector<Tally>& tallies) {
    Panel panel{.title = title, .x = {"individuals", 20, 54}, .y = {"runs that converged [%]", 0, 105}};
    for (std::size_t first = 0; first < tallies.size(); first += coarse_populations.size()) {
        auto colour = static_cast<int>(first / coarse_populations.size());
        Series shares{.name = fmt::format("{} bits", string_bits(coarse_rows[first].field_bits)), .colour = colour};
        for (std::size_t i = first; i < first + coarse_populations.size(); ++i) {
            shares.points.push_back({static_cast<double>(coarse_rows[i].population), tallies[i].converged_percent()});
            shares.intervals.push_back(success_interval(tallies[i].converged, tallies[i].runs));
        }
        panel.series.push_back(std::move(shares));
    }
    return panel;
}

/// Returns the problem's string for a bred string with these codes in the fields alpha and beta, the two fields after
/// the delay. The codes of the other fields are 0.
Genome string_at(const Recoding& reading, std::uint64_t alpha, std::uint64_t beta) {
    Genome bred(reading.length());
    bred.set_field(reading.bits[0], reading.bits[1], alpha);
    bred.set_field(reading.bits[0] + reading.bits[1], reading.bits[2], beta);
    return reading.to_problem(bred);
}

/// Returns a point for each pair of alpha and beta that the strings of a search can express.
Series grid(const Recoding& reading, const std::string& name) {
    Series points{.name = name, .stroke = Stroke::points};
    for (std::uint64_t alpha = 0; alpha < std::uint64_t{1} << reading.bits[1]; ++alpha)
        for (std::uint64_t beta = 0; beta < std::uint64_t{1} << reading.bits[2]; ++beta) {
            std::vector<double> parameters = plant_search_problem().decode(string_at(reading, alpha, beta));
            points.points.push_back({parameters[1], parameters[2]});
        }
    return points;
}

/// Returns the panel with other axes. Points outside the new axes are removed.
Panel part_of(Panel panel, const std::string& title, const Axis& x, const Axis& y) {
    panel.title = title;
    panel.x = x;
    panel.y = y;
    for (Series& series : panel.series)
        std::erase_if(series.points,
                      [&](const Point& at) { return at.x < x.from || at.x > x.to || at.y < y.from || at.y > y.to; });
    return panel;
}

/// Draws the grid of a coarse search with 4 bits for each parameter, and the grid of a fine search around one point of
/// the coarse grid.
Plot figure_6_7() {
    Recoding coarse = plant_reading(4), fine = coarse;
    fine.around = string_at(coarse, 13, 11);
    std::vector<double> bias_point = plant_search_problem().decode(*fine.around);
    Panel whole{
        .x = {"alpha", -1, 1},
        .y = {"beta", -1, 1},
        .series = {grid(coarse, "coarse, 16 x 16"),
                   grid(fine, "fine, 16 x 16"),
                   {.name = "bias point", .points = {{bias_point[1], bias_point[2]}}, .stroke = Stroke::points}}};
    return {"Figure 6.7: what a coarse and a fine search of 4 bits a parameter can express",
            {whole, part_of(whole, "around the bias point", {"alpha", 0.45, 0.8}, {"beta", 0.2, 0.55})}};
}

Replay replay_coarse_fine(const ReplayContext& context) {
    CoarseTable with_elite = coarse_table(context, "an elite of one", plant_settings, &CoarseRow::with_elite);
    CoarseTable letter = coarse_table(context, "to the letter", letter_settings, &CoarseRow::to_the_letter);
    Comparison pair = pair_table(context);
    Plot plot{"Table 6.4: coarse searches that converged before the plant changed, with 95 % intervals",
              {table_6_4_panel("an elite of one, universal sampling", with_elite.tallies),
               table_6_4_panel("as in the thesis: roulette, no elite", letter.tallies)}};
    Replay replay = replay_of(
        {with_elite.comparison, letter.comparison, pair, landscape_table(context), near_optimum_claims(context)},
        {{"table-6-4", plot}, {"figure-6-7", figure_6_7()}});
    replay.drawings = {{"figure-6-6", draw_pair(pair_settings(24, 4), plant_search_problem().parameter_names())}};
    return replay;
}

} // namespace

extern const Experiment coarse_fine_experiment{
    .name = "coarse-fine",
    .about =
        "a coarse and a fine search in place of a single search, and all strings of the coarse search: Tables 6.3, 6.4",
    .chapter = "6",
    .number = 3,
    .run = replay_coarse_fine,
    .seeds = 100,
};

} // namespace placedpar
