#include "explore/study/summary.hpp"

#include "explore/study/canonical_settings.hpp"
#include "explore/study/study_settings.hpp"
#include "runtime/kernel.hpp"

#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace placedpar {

namespace {

/// Figures of a run, one for each measure; a figure is empty if the run does not have the measure.
using Measured = std::vector<std::optional<StudyFigure>>;

Measured measured(const StudyOutcome& outcome, const std::vector<StudyMeasure>& measures) {
    Measured figures(measures.size());
    if (outcome.has_figures())
        std::ranges::transform(measures, figures.begin(),
                               [&](const StudyMeasure& each) { return each.of(outcome.figures); });
    return figures;
}

/// Divides the figures of runs by the figures of their reference runs.
class References {
public:
    References(CanonicalSettings& spellings, const std::vector<StudyMeasure>& measures, const Overrides& relative_to)
        : relative_to_(relative_to) {
        if (!relative_to.empty())
            spellings.for_each([&](const StudyRun& run, const StudyOutcome& outcome) {
                if (reference_of(run) == run)
                    references_[run] = {outcome.ended, measured(outcome, measures)};
            });
    }

    Measured relative(const StudyRun& run, const StudyOutcome& outcome, Measured figures) {
        if (relative_to_.empty())
            return figures;
        auto found = references_.find(reference_of(run));
        const bool compares = found != references_.end() && found->second.ended == outcome.ended;
        without_ += !compares && std::ranges::any_of(figures, [](const auto& figure) { return figure.has_value(); });
        for (std::size_t i = 0; i < figures.size(); ++i)
            figures[i] = compares ? ratio(figures[i], found->second.figures[i]) : std::nullopt;
        return figures;
    }
    /// Returns the number of runs with figures but without a reference run.
    std::uint64_t without() const { return without_; }

private:
    struct Reference {
        std::string ended;
        Measured figures;
    };
    static std::optional<StudyFigure> ratio(const std::optional<StudyFigure>& figure,
                                            const std::optional<StudyFigure>& reference) {
        if (!figure || !reference || reference->value == 0)
            return std::nullopt;
        return StudyFigure{figure->value / reference->value, ""};
    }

    StudyRun reference_of(StudyRun run) const {
        for (const auto& [name, value] : relative_to_)
            run.set[name] = value;
        return run;
    }

    const Overrides& relative_to_;
    std::map<StudyRun, Reference> references_;
    std::uint64_t without_ = 0;
};

/// The line of one combination, to which the runs are added.
struct Gathered {
    StudyLine line;
    void add(std::uint64_t seed, const StudyOutcome&, const Measured&, std::vector<std::string>& units);
    void count_without(const StudyOutcome&, const std::vector<StudyMeasure>&);
};

/// Counts the measures for which the run has no number.
void Gathered::count_without(const StudyOutcome& outcome, const std::vector<StudyMeasure>& measures) {
    for (const StudyMeasure& each : measures)
        if (outcome.has_figures() && each.is_in(outcome.figures) && !each.of(outcome.figures))
            ++line.without[each.text()];
}

void Gathered::add(std::uint64_t seed, const StudyOutcome& outcome, const Measured& figures,
                   std::vector<std::string>& units) {
    line.cells.resize(figures.size());
    ++line.runs;
    if (outcome.ended != name_of(RunOutcome::completed))
        ++line.ended[outcome.ended];
    if (!outcome.refused.empty() && line.refused.empty())
        line.refused = outcome.refused.substr(0, outcome.refused.find('\n'));
    StudiedRun run{.seed = seed, .ended = outcome.ended, .figures = {}};
    run.figures.resize(figures.size());
    for (std::size_t i = 0; i < figures.size(); ++i)
        if (figures[i]) {
            line.cells[i].add(figures[i]->value);
            run.figures[i] = figures[i]->value;
            units[i] = figures[i]->unit;
        }
    line.each.push_back(std::move(run));
}

/// Returns the names with their values; "" stands for a run that does not set the name.
std::map<std::string, std::set<std::string>> values_by_name(const std::map<Overrides, Gathered>& all) {
    std::map<std::string, std::set<std::string>> values;
    for (const auto& each : all)
        for (const auto& [name, value] : each.first)
            values[name].insert(value);
    for (const auto& each : all)
        for (auto& [name, known] : values)
            if (!each.first.contains(name))
                known.insert("");
    return values;
}

/// Returns keys for sorting lines by these values: numbers by size, then texts.
std::vector<std::pair<double, std::string>> order_of(const std::vector<std::string>& values) {
    std::vector<std::pair<double, std::string>> order;
    for (const std::string& value : values)
        order.emplace_back(number_of_setting(value).value_or(HUGE_VAL), value);
    return order;
}

void add_names(StudySummary& summary, const std::map<Overrides, Gathered>& all) {
    for (const auto& [name, values] : values_by_name(all))
        if (values.size() == 1)
            summary.fixed[name] = *values.begin();
        else
            summary.axes.push_back(name);
}

/// Sorts the lines by their values, numbers by size: 10 comes after 2.
void sort_lines(std::vector<StudyLine>& lines) {
    std::ranges::stable_sort(lines, {}, [](const StudyLine& line) { return order_of(line.values); });
}

void add_lines(StudySummary& summary, std::map<Overrides, Gathered>& all) {
    for (auto& [set, gathered] : all) {
        for (const std::string& axis : summary.axes)
            gathered.line.values.push_back(set.contains(axis) ? set.at(axis) : "");
        for (StudyCell& cell : gathered.line.cells)
            cell.close();
        summary.lines.push_back(std::move(gathered.line));
    }
    sort_lines(summary.lines);
}

} // namespace

void StudyCell::add(double value) {
    least = runs == 0 ? value : std::min(least, value);
    greatest = runs == 0 ? value : std::max(greatest, value);
    ++runs;
    double before = value - mean;
    mean += before / static_cast<double>(runs);
    squares_ += before * (value - mean);
}

void StudyCell::close() {
    constexpr double outside = 0.05;
    if (runs < 2)
        return;
    auto n = static_cast<double>(runs);
    double deviation = std::sqrt(squares_ / (n - 1));
    boost::math::students_t_distribution<double> student(n - 1);
    half_width = boost::math::quantile(boost::math::complement(student, outside / 2)) * deviation / std::sqrt(n);
}

std::uint64_t StudySummary::runs() const {
    std::uint64_t sum = 0;
    for (const StudyLine& line : lines)
        sum += line.runs;
    return sum;
}

std::vector<std::string> StudySummary::names() const {
    std::vector<std::string> names = axes;
    for (const auto& [name, value] : fixed)
        names.push_back(name);
    return names;
}

bool StudySummary::has_some(const Overrides& set) const {
    return std::ranges::any_of(lines, [&](const StudyLine& line) {
        return std::ranges::all_of(set, [&](const auto& setting) {
            const auto& [name, value] = setting;
            auto axis = std::ranges::find(axes, name);
            if (axis != axes.end())
                return line.values[static_cast<std::size_t>(axis - axes.begin())] == value;
            return fixed.contains(name) && fixed.at(name) == value;
        });
    });
}

StudySummary summary_of(StudyResults& results, std::vector<std::string> measures, const Study* study,
                        const Overrides& relative_to) {
    const bool of_study =
        study && !study->search; // a search summarises only the machines that it has tried, since the space may be vast
    CanonicalSettings spellings(results, study);
    StudySummary summary{
        .netlist = results.netlist(), .version = results.version(), .relative_to = spellings.of(relative_to)};
    summary.measures = measures.empty() ? results.measures() : std::move(measures);
    summary.units.resize(summary.measures.size());
    std::vector<StudyMeasure> wanted(summary.measures.begin(), summary.measures.end());
    References references(spellings, wanted, summary.relative_to);
    const StudySettings settings = of_study ? StudySettings(study->products) : StudySettings();
    std::map<Overrides, Gathered> all;
    spellings.for_each([&](const StudyRun& run, const StudyOutcome& outcome) {
        if (of_study && !settings.has(run.set))
            return;
        Gathered& gathered = all[run.set];
        gathered.add(run.seed, outcome, references.relative(run, outcome, measured(outcome, wanted)), summary.units);
        gathered.count_without(outcome, wanted);
    });
    summary.unrelated = references.without();
    add_names(summary, all);
    add_lines(summary, all);
    return summary;
}

} // namespace placedpar
