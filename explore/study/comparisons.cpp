#include "explore/study/comparisons.hpp"

#include "explore/study/spellings.hpp"
#include "runtime/kernel.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

namespace placedpar {

namespace {

using FiguresByName = StudyExpression::Figures;

/// What figures call a measure: "T_exe" is "max(master.T_exe)".
std::string name_of(const StudyMeasure& measure) {
    const std::string name = measure.name_without_subscripts();
    return name.substr(name.rfind('.') + 1); // from 0 without a dot
}

/// Makes the tables of one study.
class ComparisonMaker {
public:
    ComparisonMaker(const Study& study, StudyResults& results)
        : study_(study), results_(results), spellings_(results, &study) {}

    Comparison made(const StudyTable& table) {
        Comparison comparison{.name = table.name, .against = table.against, .judged = table.judged};
        std::vector<FiguresByName> above(table.columns.size());
        for (const StudyRow& row : table.rows)
            for (std::size_t i = 0; i < table.columns.size(); ++i) {
                const Overrides set = spellings_.of(table.set(row, table.columns[i]));
                comparison.add(cell(row, table.columns[i].name, set, i, above[i]));
                above[i][row.runs.name] = comparison.cells.back().simulated;
            }
        comparison.notes = (table.fit ? print_fit(comparison.cells) : "") + table.notes;
        return comparison;
    }

private:
    Cell cell(const StudyRow& row, const std::string& column, const Overrides& set, std::size_t place,
              const FiguresByName& above) {
        Cell cell{.row = row.runs.name, .column = column, .unit = row.unit, .decimals = row.decimals};
        cell.simulated = mean(row, set, above);
        if (place < row.origins.size())
            cell.origin = row.origins[place];
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

    double mean(const StudyRow& row, const Overrides& set, const FiguresByName& above) {
        double sum = 0;
        for (std::uint64_t i = 0; i < study_.seeds; ++i)
            sum += figure_of(row, {set, study_.first_seed + i}, above);
        return sum / static_cast<double>(study_.seeds);
    }

    double figure_of(const StudyRow& row, const StudyRun& run, FiguresByName figures) {
        const StudyOutcome outcome = outcome_of(run);
        const StudyFigures relative_to =
            row.relative_to.empty() ? StudyFigures() : outcome_of(reference(row, run)).figures;
        for (const std::string& text : study_.figures) {
            const StudyMeasure measure(text);
            auto figure = measure.of(outcome.figures);
            if (!figure)
                throw UserError(there_is_no_measure(measure, outcome.figures));
            figures[name_of(measure)] = figure->value / measure.of(relative_to).value_or(StudyFigure{1, ""}).value;
        }
        return row.figure.value(run.set, figures);
    }

    StudyRun reference(const StudyRow& row, StudyRun run) {
        for (const auto& [name, value] : row.relative_to)
            run.set[name] = value;
        return {spellings_.of(run.set), run.seed};
    }

    StudyOutcome outcome_of(const StudyRun& run) {
        const std::optional<StudyOutcome> found = results_.find(run);
        if (found && found->ended == name_of(Ending::completed))
            return *found;
        std::string how = !found ? "has not been made" : found->refused.empty() ? found->ended : found->refused;
        throw UserError(fmt::format("a table needs the run with {}: {}", run.set, how));
    }

    const Study& study_;
    StudyResults& results_;
    Spellings spellings_;
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
