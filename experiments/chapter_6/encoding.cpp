#include "experiments/chapter_6/kit/conditions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace placedpar {

namespace {

struct CodingTried {
    const char* name;
    Coding coding;
    bool spread = false;
};

constexpr CodingTried codings[]{
    {.name = "natural", .coding = NaturalCoding{}},
    {.name = "natural, stuffed a*a*a", .coding = NaturalCoding{1}},
    {.name = "natural, stuffed a***a***a", .coding = NaturalCoding{3}},
    {.name = "natural, spread start", .coding = NaturalCoding{}, .spread = true},
    {.name = "Gray", .coding = GrayCoding{}},
    {.name = "Gray, stuffed a*a*a", .coding = GrayCoding{1}},
};

/// The settings of a search, except its coding.
struct EncodingGroup {
    const char* name;
    std::size_t field_bits, population;
    bool ranking;
    Expected natural;
};

constexpr EncodingGroup encoding_groups[]{
    {.name = "37 bits, 100 individuals, linear ranking",
     .field_bits = 7,
     .population = 100,
     .ranking = true,
     .natural = {}},
    {.name = "37 bits, 30 individuals, universal sampling",
     .field_bits = 7,
     .population = 30,
     .ranking = false,
     .natural = {99, 66}},
    {.name = "22 bits, 24 individuals, universal sampling",
     .field_bits = 4,
     .population = 24,
     .ranking = false,
     .natural = {90, 38}},
};

PlantSearch search_of(const EncodingGroup& group, const CodingTried& tried) {
    PlantSearch search{plant_settings(group.population), plant_reading(group.field_bits, tried.coding), tried.spread};
    if (group.ranking)
        search.settings.reproduction = RankingReproduction();
    return search;
}

/// Judges the runs with ranking: at least 95 % must follow with Gray code, at most 45 % with natural binary.
void judge_ranking(Comparison& comparison, const std::vector<Tally>& tallies) {
    for (const Tally& tally : tallies) {
        Cell cell = plain_cell(tally.name, "followed, judged", "", tally.followed_percent(), 0);
        double most = std::max(45.0, 15 + share_tolerance(15, tally.runs)); // with few seeds, shares scatter more
        comparison.add(tally.name.starts_with("Gray") ? at_least(95, cell) : at_most(most, cell));
    }
}

ConditionGroup compare_codings(const EncodingGroup& group, const ReplayContext& context) {
    std::vector<Condition> conditions;
    for (const CodingTried& tried : codings)
        conditions.push_back({tried.name, search_of(group, tried)});
    conditions.front().expected = group.natural;
    ConditionGroup compared = compare_conditions(context, group.name, "natural binary", conditions);
    if (group.ranking)
        judge_ranking(compared.shares, compared.tallies);
    return compared;
}

Panel encoding_panel(const Comparison& shares) {
    Panel panel{.title = shares.name,
                .x = {"coding, in the order of the legend", 0, 7},
                .y = {"runs that followed [%]", 0, 105}};
    double x = 0;
    auto value = [&](const std::string& row, const std::string& column) { return figure_in(shares, row, column); };
    for (const CodingTried& tried : codings) {
        x += 1;
        panel.series.push_back({.name = tried.name,
                                .points = {{x, value(tried.name, "followed")}},
                                .stroke = Stroke::points,
                                .intervals = {{value(tried.name, "followed >="), value(tried.name, "followed <=")}}});
    }
    return panel;
}

Replay replay_encoding(const ReplayContext& context) {
    std::vector<Comparison> comparisons;
    Plot plot{"Codings of the plant's string: runs that follow the change, with 95 % intervals", {}};
    for (const EncodingGroup& group : encoding_groups) {
        ConditionGroup compared = compare_codings(group, context);
        plot.panels.push_back(encoding_panel(compared.shares));
        comparisons.push_back(std::move(compared.shares));
        comparisons.push_back(std::move(compared.gains));
    }
    return replay_of(std::move(comparisons), {{"encoding", plot}});
}

} // namespace

extern const Experiment encoding_experiment{
    .name = "encoding",
    .about = "natural binary, Gray code, don't-care bits and a spread start, on the plant of chapter 5",
    .chapter = "6",
    .number = 4,
    .run = replay_encoding,
    .seeds = 100,
};

} // namespace placedpar
