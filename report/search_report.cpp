#include "report/search_report.hpp"

#include "text/paint.hpp"
#include "text/statistics.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace placedpar {

namespace {

/// A search, or all together, from its first generation to its last.
struct SearchSummary {
    std::string process;
    std::size_t generations;
    LoggedGeneration first, last;
    std::size_t nearly_there; ///< the generation by which the best so far had come 99 % of its way
    std::size_t accepted = 0, turned_away = 0;
    bool of_all = false;
};

bool is_finite(const LoggedGeneration& generation) { return std::isfinite(generation.best_so_far); }

std::size_t generation_nearly_there(std::span<const LoggedGeneration> generations) {
    auto begin = std::ranges::find_if(generations, &is_finite);
    if (begin == generations.end())
        return 1;
    double first = begin->best_so_far, last = generations.back().best_so_far;
    auto there = std::find_if(begin, generations.end(), [&](const LoggedGeneration& each) {
        return std::abs(last - each.best_so_far) <= 0.01 * std::abs(last - first);
    });
    return static_cast<std::size_t>(there - generations.begin()) + 1;
}

SearchSummary summary_of(const std::string& name, std::span<const LoggedGeneration> generations) {
    return {name, generations.size(), generations.front(), generations.back(), generation_nearly_there(generations)};
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
            summaries.push_back(summary_of(log.searches()[i], log.of(i)));
            count_immigrants(log, i, summaries.back());
        }
    if (!log.of_all().empty()) {
        summaries.push_back(summary_of("all", log.of_all()));
        count_immigrants(log, std::nullopt, summaries.back());
        summaries.back().of_all = true;
    }
    return summaries;
}

/// Of the names in a first column.
std::size_t width_of_names(const std::vector<SearchSummary>& rows) {
    std::size_t width = 6;
    for (const SearchSummary& row : rows)
        width = std::max(width, row.process.size());
    return width;
}

std::string print_between(const SearchSummary& all) {
    return fmt::format("diversity between searches: {:.4f} in the first generation, {:.4f} in the last\n",
                       all.first.between, all.last.between);
}

/// "120 [100, 131]": the median of a figure of several runs, and its quartiles.
template <class Figure>
std::string print_middle(const std::vector<std::vector<SearchSummary>>& runs, std::size_t row, Figure figure) {
    std::vector<double> values;
    for (const auto& run : runs)
        values.push_back(static_cast<double>(figure(run[row])));
    return fmt::format("{:.6g} [{:.6g}, {:.6g}]", median(values), quantile(values, 0.25), quantile(values, 0.75));
}

std::string print_middles(const std::vector<std::vector<SearchSummary>>& runs) {
    std::size_t width = width_of_names(runs.front());
    std::string out = painted(Paint::heading,
                              fmt::format("\n{:<{}}  {:>28}  {:>28}  {:>28}  {:>20}  {:>24}\n", "search", width,
                                          "best, last", "ever", "mean, last", "99 % at generation", "diversity, last"));
    for (std::size_t i = 0; i < runs.front().size(); ++i)
        out += fmt::format("{:<{}}  {:>28}  {:>28}  {:>28}  {:>20}  {:>24}\n", runs.front()[i].process, width,
                           print_middle(runs, i, [](const SearchSummary& s) { return s.last.best; }),
                           print_middle(runs, i, [](const SearchSummary& s) { return s.last.best_so_far; }),
                           print_middle(runs, i, [](const SearchSummary& s) { return s.last.mean; }),
                           print_middle(runs, i, [](const SearchSummary& s) { return s.nearly_there; }),
                           print_middle(runs, i, [](const SearchSummary& s) { return s.last.diversity; }));
    return out + "medians, and quartiles in brackets\n";
}

/// JSON knows no other numbers.
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

} // namespace

std::string print_searches(const GenerationLog& log) {
    auto rows = summaries_of(log);
    if (rows.empty())
        return "";
    std::size_t width = width_of_names(rows);
    std::string out =
        painted(Paint::heading,
                fmt::format("\n{:<{}}  {:>11}  {:>11}  {:>11}  {:>11}  {:>11}  {:>11}  {:>7}  {:>9}  {:>8}  {:>11}\n",
                            "search", width, "generations", "best, first", "last", "ever", "mean, first", "last",
                            "99 % at", "diversity", "accepted", "turned away"));
    for (const SearchSummary& s : rows)
        out += fmt::format(
            "{:<{}}  {:>11}  {:>11.6g}  {:>11.6g}  {:>11.6g}  {:>11.6g}  {:>11.6g}  {:>7}  {:>9.4f}  {:>8}  {:>11}\n",
            s.process, width, s.generations, s.first.best, s.last.best, s.last.best_so_far, s.first.mean, s.last.mean,
            s.nearly_there, s.last.diversity, s.accepted, s.turned_away);
    return rows.back().of_all ? out + print_between(rows.back()) : out;
}

std::string print_searches(std::span<const SeededLog> logs) {
    std::vector<std::vector<SearchSummary>> runs;
    for (const SeededLog& each : logs)
        runs.push_back(summaries_of(each.log));
    bool alike = std::ranges::all_of(runs, [&](const auto& run) { return run.size() == runs.front().size(); });
    return runs.front().empty() || !alike ? "" : print_middles(runs);
}

boost::json::array searches_json(const GenerationLog& log) {
    boost::json::array json;
    for (const SearchSummary& s : summaries_of(log))
        json.push_back(boost::json::object{{"process", s.process},
                                           {"generations", s.generations},
                                           {"first", generation_json(s.first, s.of_all)},
                                           {"last", generation_json(s.last, s.of_all)},
                                           {"best_so_far", finite_json(s.last.best_so_far)},
                                           {"generation_at_99_percent", s.nearly_there},
                                           {"immigrants_accepted", s.accepted},
                                           {"immigrants_turned_away", s.turned_away}});
    return json;
}

} // namespace placedpar
