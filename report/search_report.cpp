#include "report/search_report.hpp"

#include "report/field.hpp"
#include "text/statistics.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <vector>

namespace placedpar {

namespace {

/// Summarises one search, or all searches together, from the first generation to the last.
struct SearchSummary {
    std::string process;
    std::size_t generations;
    LoggedGeneration first, last;
    std::uint64_t nearly_there; ///< the first generation in which the best value so far has made 99 % of its progress
    std::size_t accepted = 0, turned_away = 0;
    bool of_all = false;
};

bool is_finite(const LoggedStep& step) { return std::isfinite(step.value); }

/// REQUIRES: there is a step.
std::uint64_t generation_nearly_there(const std::vector<LoggedStep>& steps) {
    const auto begin = std::ranges::find_if(steps, is_finite);
    if (begin == steps.end())
        return steps.front().generation;
    const double first = begin->value, last = steps.back().value;
    return std::find_if(
               begin, steps.end(),
               [&](const LoggedStep& each) { return std::abs(last - each.value) <= 0.01 * std::abs(last - first); })
        ->generation;
}

SearchSummary summary_of(const std::string& name, std::span<const LoggedGeneration> generations,
                         const std::vector<LoggedStep>& steps) {
    return {name, generations.size(), generations.front(), generations.back(), generation_nearly_there(steps)};
}

void count_immigrants(const GenerationLog& log, std::optional<std::size_t> search, SearchSummary& summary) {
    for (const LoggedMigration& each : log.migrations())
        if (!search || each.to == *search)
            ++(each.accepted ? summary.accepted : summary.turned_away);
}

std::vector<SearchSummary> summaries_of(const GenerationLog& log) {
    std::vector<SearchSummary> summaries;
    for (std::size_t i = 0; i < log.searches().size(); ++i)
        if (!log.of(i).empty()) {
            summaries.push_back(summary_of(log.searches()[i], log.of(i), log.steps_of(i)));
            count_immigrants(log, i, summaries.back());
        }
    if (!log.of_all().empty()) {
        summaries.push_back(summary_of("all", log.of_all(), log.steps_of_all()));
        count_immigrants(log, std::nullopt, summaries.back());
        summaries.back().of_all = true;
    }
    return summaries;
}

std::string print_between(const SearchSummary& all, std::uint64_t first) {
    return fmt::format("diversity between searches: {:.4f} in {}, {:.4f} in the last\n", all.first.between,
                       first == 1 ? "the first generation" : fmt::format("generation {}", first), all.last.between);
}

/// Says which search first found the best value of an objective. Values of searches with records are not compared,
/// since their windows may differ.
std::string print_finder(const GenerationLog& log) {
    if (!log.compares() || !log.has_objective(0) || log.of_all().empty() || !is_finite(log.steps_of_all().back()))
        return "";
    const LoggedStep best = log.steps_of_all().back();
    std::size_t finder = 0;
    while (std::ranges::count(log.steps_of(finder), best) == 0)
        ++finder;
    return fmt::format("best of all: {:.6g}, first found by {} in generation {}\n", best.value, log.searches()[finder],
                       best.generation);
}

/// Returns the median of a figure over several runs, and its quartiles: "120 [100, 131]".
template <class Figure>
std::string print_middle(const std::vector<std::vector<SearchSummary>>& runs, std::size_t row, Figure figure) {
    std::vector<double> values;
    for (const auto& run : runs)
        values.push_back(static_cast<double>(figure(run[row])));
    return fmt::format("{:.6g} [{:.6g}, {:.6g}]", median(values), quantile(values, 0.25), quantile(values, 0.75));
}

std::string print_middles(const std::vector<std::vector<SearchSummary>>& runs) {
    std::vector<std::size_t> searches(runs.front().size());
    std::iota(searches.begin(), searches.end(), std::size_t{0});
    Table table = table_of(searches, [&](std::size_t i) -> Row {
        auto middle = [&](std::size_t width, const char* heading, auto figure) {
            return Field::right(width, heading, print_middle(runs, i, figure));
        };
        return {Field::left(0, "search", runs.front()[i].process),
                middle(28, "best, last", [](const SearchSummary& s) { return s.last.best; }),
                middle(28, "ever", [](const SearchSummary& s) { return s.last.best_so_far; }),
                middle(28, "mean, last", [](const SearchSummary& s) { return s.last.mean; }),
                middle(20, "99 % at generation", [](const SearchSummary& s) { return s.nearly_there; }),
                middle(24, "diversity, last", [](const SearchSummary& s) { return s.last.diversity; })};
    });
    return table.text("\n") + "medians, and quartiles in brackets\n";
}

/// Returns null for numbers that are not finite, since JSON has none.
boost::json::value finite_json(double number) {
    return std::isfinite(number) ? boost::json::value(number) : boost::json::value();
}

boost::json::object generation_json(const LoggedGeneration& generation, bool of_all) {
    boost::json::object json{{"best", finite_json(generation.best)},
                             {"mean", finite_json(generation.mean)},
                             {"diversity", generation.diversity}};
    if (of_all)
        json["diversity_between"] = generation.between;
    return json;
}

Row row_of(const SearchSummary& s) {
    auto figure = [](const char* heading, double number) {
        return Field::right(11, heading, fmt::format("{:.6g}", number));
    };
    return {
        Field::left(0, "search", s.process).as("process"),
        Field::count(11, "generations", s.generations),
        Field::member("first", generation_json(s.first, s.of_all)),
        Field::member("last", generation_json(s.last, s.of_all)),
        figure("best, first", s.first.best),
        figure("last", s.last.best),
        figure("ever", s.last.best_so_far).as("best_so_far", finite_json(s.last.best_so_far)),
        figure("mean, first", s.first.mean),
        figure("last", s.last.mean),
        Field::right(7, "99 % at", fmt::format("{}", s.nearly_there)).as("generation_at_99_percent", s.nearly_there),
        Field::right(9, "diversity", fmt::format("{:.4f}", s.last.diversity)),
        Field::right(8, "accepted", fmt::format("{}", s.accepted)).as("immigrants_accepted", s.accepted),
        Field::right(11, "turned away", fmt::format("{}", s.turned_away)).as("immigrants_turned_away", s.turned_away)};
}

} // namespace

std::string print_searches(const GenerationLog& log) {
    auto rows = summaries_of(log);
    if (rows.empty())
        return "";
    std::string out = table_of(rows, row_of).text("\n");
    if (log.first() > 1)
        out += fmt::format("this run continues from a checkpoint: \"first\" is generation {}\n", log.first());
    return rows.back().of_all ? out + print_between(rows.back(), log.first()) + print_finder(log) : out;
}

std::string print_searches(std::span<const SeededLog> logs) {
    std::vector<std::vector<SearchSummary>> runs;
    for (const SeededLog& each : logs)
        runs.push_back(summaries_of(each.log));
    bool alike = std::ranges::all_of(runs, [&](const auto& run) { return run.size() == runs.front().size(); });
    return runs.front().empty() || !alike ? "" : print_middles(runs);
}

boost::json::array searches_json(const GenerationLog& log) { return json_of(table_of(summaries_of(log), row_of).rows); }

} // namespace placedpar
