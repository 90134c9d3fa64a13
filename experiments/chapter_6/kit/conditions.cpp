#include "experiments/chapter_6/kit/conditions.hpp"

#include "experiments/kit/bootstrap.hpp"
#include "text/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace placedpar {

namespace {

double share(std::size_t part, std::size_t all) { return 100 * static_cast<double>(part) / static_cast<double>(all); }

void add_share(Comparison& comparison, const Tally& tally, const std::string& column, std::size_t successes,
               std::optional<double> expected) {
    auto tolerance = expected ? std::optional(share_tolerance(*expected, tally.runs)) : std::nullopt;
    comparison.add(cell_of(tally.name, column, "", expected, share(successes, tally.runs), tolerance, 0));
    Interval interval = success_interval(successes, tally.runs);
    comparison.add(plain_cell(tally.name, column + " >=", "", interval.low, 0));
    comparison.add(plain_cell(tally.name, column + " <=", "", interval.high, 0));
}

Figures figures_of(const PlantOutcome& outcome) {
    return {outcome.pole_error[0], outcome.pole_error[1], outcome.pole_error[2], outcome.converged_at};
}

PlantOutcome outcome_of(const Figures& figures) { return {{figures[0], figures[1], figures[2]}, figures[3]}; }

} // namespace

double Tally::converged_percent() const { return share(converged, runs); }
double Tally::followed_percent() const { return share(followed, runs); }

Tally tally_runs(const ReplayContext& context, const std::string& name,
                 const std::function<PlantOutcome(std::uint64_t)>& run) {
    Tally tally{name};
    for (const Figures& figures : run_seeds(context, name, [&](std::uint64_t seed) { return figures_of(run(seed)); })) {
        PlantOutcome outcome = outcome_of(figures);
        ++tally.runs;
        tally.converged += outcome.converged();
        tally.followed += outcome.followed();
        tally.converged_at.push_back(outcome.converged_at);
    }
    return tally;
}

Tally tally_search(const ReplayContext& context, const std::string& name, const PlantSearch& search) {
    return tally_runs(context, name, [&](std::uint64_t seed) { return run_plant_search(search, seed); });
}

void add_tally(Comparison& comparison, const Tally& tally, const Expected& expected) {
    add_share(comparison, tally, "converged", tally.converged, expected.converged);
    add_share(comparison, tally, "followed", tally.followed, expected.followed);
    Interval interval = median_interval(tally.converged_at);
    comparison.add(plain_cell(tally.name, "generation", "", median(tally.converged_at), 0));
    comparison.add(plain_cell(tally.name, "generation >=", "", interval.low, 0));
    comparison.add(plain_cell(tally.name, "generation <=", "", interval.high, 0));
}

void add_gain(Comparison& comparison, const Tally& control, const Tally& tally) {
    auto add = [&](const std::string& column, std::size_t of_control, std::size_t of_tally) {
        Interval gain = difference_interval(of_control, control.runs, of_tally, tally.runs);
        comparison.add(plain_cell(tally.name, column + " >=", "", gain.low, 0));
        comparison.add(plain_cell(tally.name, column + " <=", "", gain.high, 0));
    };
    add("converged", control.converged, tally.converged);
    add("followed", control.followed, tally.followed);
}

ConditionGroup compare_conditions(const ReplayContext& context, const std::string& name, const std::string& control,
                                  const std::vector<Condition>& conditions) {
    ConditionGroup group{{.name = name, .against = "other", .judged = true},
                         {.name = fmt::format("{}: percentage points above {}", name, control)},
                         {}};
    for (const Condition& each : conditions) {
        Tally tally = tally_search(context, fmt::format("{}, {}", name, each.name), each.search);
        tally.name = each.name;
        add_tally(group.shares, tally, each.expected);
        if (!group.tallies.empty())
            add_gain(group.gains, group.tallies.front(), tally);
        group.tallies.push_back(std::move(tally));
    }
    return group;
}

double figure_in(const Comparison& table, const std::string& row, const std::string& column) {
    return std::ranges::find_if(table.cells, [&](const Cell& cell) { return cell.row == row && cell.column == column; })
        ->simulated;
}

} // namespace placedpar
