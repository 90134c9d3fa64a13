#include "explore/compare/comparison.hpp"
#include "explore/study/measure.hpp"
#include "text/counted.hpp"
#include "text/paint.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace placedpar {

namespace {

std::string share_of(Time part, Time whole) {
    return whole == Time{0} ? "-" : fmt::format("{:+.1f} %", 100 * in_milliseconds(part) / in_milliseconds(whole));
}

std::string print_ending(const char* letter, const std::string& name, const RunReport& report, const Network& network) {
    return fmt::format("{}  {}: {} at {}; hash {:016x}\n", letter, name, name_of(report.outcome()),
                       to_string(report.result.time), network.hash);
}

/// Returns the elements that only one network has, as in "; 2 only in A: x, y". Returns "" for an empty list.
std::string print_only(const std::vector<std::string>& only, const char* where) {
    constexpr std::size_t most = 4;
    if (only.empty())
        return "";
    const auto end = only.begin() + static_cast<std::ptrdiff_t>(std::min(most, only.size()));
    return fmt::format("; {} only in {}: {}{}", only.size(), where, fmt::join(only.begin(), end, ", "),
                       only.size() > most ? ", ..." : "");
}

std::string print_structure(const NetlistComparison& compared) {
    std::string out;
    for (const StructureDifference& each : compared.structure) {
        const std::string text = print_only(each.only_a, "A") + print_only(each.only_b, "B");
        out += fmt::format("  {}: {}{}\n", name_of(each.section), text.substr(2),
                           compared.following.contains(each.section) ? "; follows from the vals" : "");
    }
    return out;
}

std::string print_setting(const SettingDifference& each) {
    return fmt::format("  {}{}: {} in A, {} in B\n", each.elements.empty() ? "val " : "", each.name, each.a, each.b);
}

std::string print_differences(const NetlistComparison& compared) {
    std::string out;
    for (const SettingDifference& each : compared.settings)
        out += each.elements.empty()
                   ? print_setting(each)
                   : fmt::format("{} ({})\n", print_setting(each).substr(0, print_setting(each).size() - 1),
                                 counted(each.elements.size(), "element"));
    out += print_structure(compared);
    return painted(Paint::heading, "\nwhat differs\n") + (out.empty() ? "  nothing in the netlists\n" : out);
}

std::string print_row(Time change, Time whole, const std::string& what) {
    return fmt::format("{:>+14.6f}  {:>9}  {}\n", in_milliseconds(change), share_of(change, whole), what);
}

std::string print_change(const OneChange& change, Time of_a) {
    if (change.completed())
        return print_row(change.time - of_a, of_a, change.what);
    return fmt::format("{:>25}  {}{}\n", change.refused.empty() ? name_of(change.outcome) : "not alone", change.what,
                       change.refused.empty() ? "" : ": " + change.refused);
}

Time sum_of(const std::vector<OneChange>& changes, Time of_a) {
    Time sum{0};
    for (const OneChange& each : changes)
        if (each.completed())
            sum += each.time - of_a;
    return sum;
}

/// Prints how much of the difference in time appears only in runs that combine several changes.
std::string print_verdict(const NetlistComparison& compared, Time sum) {
    const Time rest = compared.difference() - sum;
    if (compared.alone.empty())
        return "";
    const bool all_ran = std::ranges::all_of(compared.alone, &OneChange::completed);
    if (all_ran && std::chrono::abs(rest) * 1000 <= std::chrono::abs(compared.difference()))
        return "The differences add up: none changes the effect of another.\n";
    return fmt::format("{:+.6f} ms remain: {}.\n", in_milliseconds(rest),
                       all_ran ? "the differences interact, and this part appears only if they are combined"
                               : "they come from interactions, and from differences that could not be applied alone");
}

std::string print_changes(const NetlistComparison& compared) {
    const Time of_a = compared.report_a.result.time;
    const Time sum = sum_of(compared.alone, of_a);
    std::vector<OneChange> changes = compared.alone;
    std::ranges::stable_sort(changes, std::greater(), [&](const OneChange& each) {
        return each.completed() ? std::chrono::abs(each.time - of_a) : Time{-1};
    });
    std::string out = painted(Paint::heading,
                              fmt::format("\n{:>14}  {:>9}  {}\n", "ms", "of A", "one difference, applied alone to A"));
    for (const OneChange& each : changes)
        out += print_change(each, of_a);
    if (changes.size() > 1)
        out += print_row(sum, of_a, "the sum of these");
    if (compared.together)
        out += print_change(*compared.together, of_a);
    out += print_row(compared.difference(), of_a, "B");
    return out + print_verdict(compared, sum);
}

struct FigureRow {
    std::string name;
    double a, b;

    double relative() const { return std::abs(b - a) / std::max(std::abs(a), std::abs(b)); }
};

/// Prints the measures of both runs that differ most, relative to their values.
std::string print_figures(const NetlistComparison& compared) {
    constexpr std::size_t most = 10;
    const StudyFigures figures_a = figures_of(compared.report_a, compared.a),
                       figures_b = figures_of(compared.report_b, compared.b);
    std::vector<FigureRow> rows;
    for (const auto& [name, figure] : figures_a)
        if (auto other = figures_b.find(name); other != figures_b.end() && std::isfinite(figure.value) &&
                                               std::isfinite(other->second.value) &&
                                               other->second.value != figure.value)
            rows.push_back(
                {name + (figure.unit.empty() ? "" : " [" + figure.unit + "]"), figure.value, other->second.value});
    std::ranges::stable_sort(rows, std::greater(), &FigureRow::relative);
    if (rows.empty())
        return "\nAll measures of both runs are equal.\n";
    std::string out =
        painted(Paint::heading, fmt::format("\n{:>14}  {:>14}  {}\n", "A", "B", "measures that differ most"));
    for (std::size_t i = 0; i < std::min(most, rows.size()); ++i)
        out += fmt::format("{:>14.6g}  {:>14.6g}  {}\n", rows[i].a, rows[i].b, rows[i].name);
    return rows.size() > most ? out + fmt::format("{:>32}{} more\n", "", rows.size() - most) : out;
}

} // namespace

std::string print_compared(const NetlistComparison& compared) {
    std::string out = print_ending("A", compared.name_a, compared.report_a, compared.a) +
                      print_ending("B", compared.name_b, compared.report_b, compared.b) + print_differences(compared);
    if (!compared.both_completed())
        return out + "\nNo difference was applied alone, because one of the runs does not complete.\n";
    return out + (compared.alone.empty() ? "" : print_changes(compared)) + print_figures(compared);
}

} // namespace placedpar
