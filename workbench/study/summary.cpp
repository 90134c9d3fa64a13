#include "workbench/study/summary.hpp"

#include "runtime/kernel.hpp"

#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace placedpar {

namespace {

/// The runs of one combination while they are added.
struct Gathered {
    StudyLine line;
    void add(const StudyOutcome&, const std::vector<StudyMeasure>&, std::vector<std::string>& units);
};

void Gathered::add(const StudyOutcome& outcome, const std::vector<StudyMeasure>& measures,
                   std::vector<std::string>& units) {
    line.cells.resize(measures.size());
    ++line.runs;
    if (outcome.ended != name_of(Ending::completed))
        ++line.ended[outcome.ended];
    if (!outcome.refused.empty() && line.refused.empty())
        line.refused = outcome.refused.substr(0, outcome.refused.find('\n'));
    if (outcome.ended == name_of(Ending::stuck)) // what it measured until then is of no whole
        return;
    for (std::size_t i = 0; i < measures.size(); ++i)
        if (std::optional<StudyFigure> figure = measures[i].of(outcome.figures)) {
            line.cells[i].add(figure->value);
            units[i] = figure->unit;
        }
}

/// Names, each with the values that it has; "" where it is not set.
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

/// Numbers before texts, and by size.
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

/// So that 10 comes after 2.
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

StudySummary summary_of(StudyResults& results, std::vector<std::string> measures, const Study* study) {
    const bool of_study = study && !study->search; // a search asks for what it has tried, of a space that may be vast
    StudySummary summary{.netlist = results.netlist(), .version = results.version()};
    summary.measures = measures.empty() ? results.measures() : std::move(measures);
    summary.units.resize(summary.measures.size());
    std::vector<StudyMeasure> wanted(summary.measures.begin(), summary.measures.end());
    std::map<Overrides, Gathered> all;
    results.for_each([&](const StudyRun& run, const StudyOutcome& outcome) {
        if (!of_study || study->has(run.set))
            all[run.set].add(outcome, wanted, summary.units);
    });
    add_names(summary, all);
    add_lines(summary, all);
    return summary;
}

} // namespace placedpar
