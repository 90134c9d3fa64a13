#include "explore/study/comparisons.hpp"

#include "explore/study/canonical_settings.hpp"
#include "explore/study/summary.hpp"
#include "explore/study/summary_cells.hpp"
#include "runtime/kernel.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

namespace placedpar {

namespace {

using FiguresByName = StudyExpression::Figures;

/// Collects the reasons why cells of a table have no figure, with the settings of these cells.
class MissingFigures {
public:
    void add(const Overrides& set, const UserError& why) {
        const std::string said = why.what();
        runs_[said.substr(0, said.find('\n'))].push_back(shown_settings(set));
    }
    std::string print() const {
        std::string out;
        for (const auto& [why, runs] : runs_)
            out += fmt::format("-: the run with {}{} has no figure: {}\n", runs.front(),
                               runs.size() == 1 ? "" : fmt::format(" ({} such cells)", runs.size()), why);
        return out;
    }

private:
    std::map<std::string, std::vector<std::string>> runs_;
};

class ComparisonMaker {
public:
    ComparisonMaker(const Study& study, StudyResults& results)
        : study_(study), results_(results), spellings_(results, &study) {}

    Comparison made(const StudyTable& table) {
        Comparison comparison{.name = table.name, .against = table.against, .judged = table.judged};
        std::vector<FiguresByName> above(table.columns.size());
        MissingFigures missing;
        for (const StudyRow& row : table.rows) {
            for (std::size_t i = 0; i < table.columns.size(); ++i) {
                const Overrides set = spellings_.of(table.set(row, table.columns[i]));
                comparison.add(cell(row, table.columns[i].name, set, i, above[i], missing));
                above[i][row.runs.name] = comparison.cells.back().simulated;
            }
            if (row.interval)
                add_interval(comparison, row, table.columns.size());
        }
        comparison.notes = missing.print() + (table.fit ? print_fit(comparison.cells) : "") + table.notes;
        return comparison;
    }

private:
    Cell cell(const StudyRow& row, const std::string& column, const Overrides& set, std::size_t place,
              const FiguresByName& above, MissingFigures& missing) {
        Cell cell{
            .row = row.runs.name, .column = column, .unit = row.unit, .decimals = row.decimals, .judge = row.judge};
        try {
            set_figure(cell, row, set, above);
        } catch (const UserError& why) {
            cell.simulated = std::nan("");
            missing.add(set, why);
        }
        if (place < row.origins.size())
            cell.origin = row.origins[place];
        if (place < row.at_least.size() && row.at_least[place])
            cell.at_least = row.at_least[place].value(set, {});
        if (place < row.at_most.size() && row.at_most[place])
            cell.at_most = row.at_most[place].value(set, {});
        if (place >= row.known.size() || !row.known[place])
            return cell;
        cell.reference = row.known[place].value(set, {});
        if (place < row.tolerances.size() && row.tolerances[place].amount) {
            const StudyTolerance& tolerance = row.tolerances[place];
            (tolerance.in_percent ? cell.tolerance_percent : cell.tolerance) =
                tolerance.amount.value(set, {{"known", *cell.reference}});
        }
        return cell;
    }

    /// Sets the mean over the seeds and, for several seeds, its interval. If a percentage is 0 or 100 in every run, the
    /// interval is computed as for a share of the runs.
    void set_figure(Cell& cell, const StudyRow& row, const Overrides& set, const FiguresByName& above) {
        StudyCell figures;
        std::size_t none = 0, all = 0;
        for (std::uint64_t i = 0; i < study_.seeds; ++i) {
            const double figure = figure_of(row, {set, study_.first_seed + i}, above);
            figures.add(figure);
            none += figure == 0;
            all += figure == 100;
        }
        figures.close();
        cell.simulated = figures.mean;
        if (study_.seeds == 1)
            return;
        cell.interval = none + all == figures.runs && cell.unit == "%"
                            ? success_interval(all, figures.runs)
                            : Interval{figures.mean - figures.half_width, figures.mean + figures.half_width};
    }

    /// Adds two rows with the ends of the intervals of the last `columns` cells.
    static void add_interval(Comparison& comparison, const StudyRow& row, std::size_t columns) {
        const std::vector<Cell> cells(comparison.cells.end() - static_cast<std::ptrdiff_t>(columns),
                                      comparison.cells.end());
        for (const bool upper : {false, true})
            for (const Cell& each : cells) {
                const Interval ends = each.interval.value_or(Interval{std::nan(""), std::nan("")});
                comparison.add(plain_cell(row.runs.name + (upper ? ", to" : ", 95 % from"), each.column, row.unit,
                                          upper ? ends.high : ends.low, row.decimals));
            }
    }

    double figure_of(const StudyRow& row, const StudyRun& run, const FiguresByName& above) {
        const StudyOutcome outcome = outcome_of(run);
        const StudyFigures relative_to =
            row.relative_to.empty() ? StudyFigures() : outcome_of(reference(row, run)).figures;
        auto value = [&](const StudyMeasure& measure) {
            return measured(measure, outcome.figures) / (row.relative_to.empty() ? 1 : measured(measure, relative_to));
        };
        if (!row.measure.empty())
            return value(StudyMeasure(row.measure));
        const std::set<std::string> names = row.figure.names();
        FiguresByName figures;
        for (const std::string& name : names)
            if (auto found = above.find(name); found != above.end())
                figures.insert(*found);
        for (const std::string& text : study_.figures)
            if (const StudyMeasure measure(text); names.contains(measure.last_name()))
                figures[measure.last_name()] = value(measure);
        return row.figure.value(run.set, figures);
    }

    static double measured(const StudyMeasure& measure, const StudyFigures& figures) {
        auto figure = measure.of(figures);
        if (!figure)
            throw UserError(there_is_no_measure(measure, figures));
        return figure->value;
    }

    StudyRun reference(const StudyRow& row, StudyRun run) {
        for (const auto& [name, value] : row.relative_to)
            run.set[name] = value;
        return {spellings_.of(run.set), run.seed};
    }

    StudyOutcome outcome_of(const StudyRun& run) {
        const std::optional<StudyOutcome> found = results_.find(run);
        if (!found)
            throw std::invalid_argument(
                fmt::format("a table needs the run with {}, which has not been made", shown_settings(run.set)));
        if (found->ended != name_of(RunOutcome::completed))
            throw UserError(found->refused.empty() ? found->ended : found->refused);
        return *found;
    }

    const Study& study_;
    StudyResults& results_;
    CanonicalSettings spellings_;
};

} // namespace

std::vector<Comparison> comparisons_of(const Study& study, StudyResults& results) {
    ComparisonMaker maker(study, results);
    std::vector<Comparison> all;
    for (const StudyTable& table : study.tables)
        all.push_back(maker.made(table));
    return all;
}

} // namespace placedpar
