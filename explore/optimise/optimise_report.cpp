#include "explore/optimise/optimise_report.hpp"

#include "text/counted.hpp"
#include "text/paint.hpp"
#include "text/program_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <utility>

namespace placedpar {

namespace {

constexpr std::size_t most_machines = 5;  ///< machines shown if there is one cost
constexpr std::size_t most_reasons = 5;   ///< number of shown reasons why machines are infeasible
constexpr std::size_t most_path_rows = 8; ///< rows shown for the parts of the paths

using Costs = std::vector<double>;

/// Returns the indices of the course's feasible machines, the best first; if there are several costs, only the machines
/// on the front.
std::vector<std::size_t> in_order_of_costs(const SearchCourse& course) {
    std::vector<std::size_t> front = course.front();
    if (!front.empty() && course.merits[front.front()].costs.size() > 1)
        return front;
    std::vector<std::size_t> order = order_of(course.merits);
    std::erase_if(order, [&](std::size_t place) { return !course.merits[place].feasible; });
    return order;
}

/// Returns the costs on the front, each once.
std::set<Costs> costs_on_front(const SearchCourse& course) {
    std::set<Costs> costs;
    for (std::size_t place : course.front())
        costs.insert(course.merits[place].costs);
    return costs;
}

std::string comparison_row(const std::string& way, const std::string& machines, const std::string& first,
                           const std::string& second) {
    return fmt::format("{:<12}{:>10}  {:>24}  {:>14}", way, machines, first, second);
}

std::string print_cost(const Costs& costs) { return fmt::format("{:.6g}", costs.front()); }

std::string without_blanks_behind(std::string line) { return line.erase(line.find_last_not_of(' ') + 1); }

std::string refusal_line(const std::string& why) { return why.substr(0, why.find('\n')); }

std::string print_start(const Trial& start) {
    return comparison_row("as it is", "1",
                          start.merit.feasible ? print_cost(start.merit.costs) : refusal_line(start.why), "");
}

/// Prints how many points of the joint front a course found; for one cost, prints the best value and the number of
/// machines tried until it was found.
std::string print_course(const SearchCourse& course, const std::set<Costs>& joint) {
    std::string machines = std::to_string(course.machines.size());
    std::set<Costs> own = costs_on_front(course);
    if (own.empty())
        return without_blanks_behind(comparison_row(course.way, machines, "none", ""));
    if (own.begin()->size() == 1)
        return comparison_row(course.way, machines, print_cost(*own.begin()),
                              std::to_string(course.front().front() + 1));
    auto shared = std::ranges::count_if(own, [&](const Costs& costs) { return joint.contains(costs); });
    return comparison_row(course.way, machines, std::to_string(own.size()),
                          fmt::format("{} of {}", shared, joint.size()));
}

double sum_of(const std::vector<PathShare>& shares) {
    double sum = 0;
    for (const PathShare& share : shares)
        sum += in_milliseconds(share.time);
    return sum;
}

std::string print_path_row(double start, double best, const std::string& name) {
    return fmt::format("{:>12.3f}  {:>12.3f}  {:>+12.3f}  {}\n", start, best, best - start, name);
}

std::string option(const std::string& name, const std::string& value) { return " " + name + " " + shell_word(value); }

} // namespace

SearchCourse Optimum::together() const {
    SearchCourse all{.way = "all"};
    for (const SearchCourse& course : courses)
        for (std::size_t place = 0; place < course.machines.size(); ++place)
            if (all.tried.insert(course.machines[place]).second) {
                all.machines.push_back(course.machines[place]);
                all.merits.push_back(course.merits[place]);
            }
    return all;
}

std::vector<std::size_t> best_of(const SearchCourse& course) {
    std::vector<std::size_t> places;
    std::set<Costs> seen;
    for (std::size_t place : in_order_of_costs(course))
        if (const Costs& costs = course.merits[place].costs;
            (costs.size() > 1 || places.size() < most_machines) && seen.insert(costs).second)
            places.push_back(place);
    return places;
}

std::vector<std::string> shown_measures(const Study& study) {
    std::vector<std::string> measures = study.search->minimise;
    std::ranges::copy_if(study.measures, std::back_inserter(measures), [&](const std::string& each) {
        return std::ranges::find(study.search->minimise, each) == study.search->minimise.end();
    });
    return measures;
}

StudySummary summary_of_best(StudyResults& results, const Study& study, const MachineSpace& space,
                             const SearchCourse& course) {
    std::vector<Overrides> best;
    for (std::size_t place : best_of(course))
        best.push_back(space.settings(course.machines[place]));
    const Study shown = study_of(study, best);
    StudySummary summary = summary_of(results, shown_measures(study), &shown);
    std::ranges::stable_sort(summary.lines, {}, [](const StudyLine& line) { return line.cells.front().mean; });
    return summary;
}

std::string print_comparison(const Optimum& optimum) {
    bool two = optimum.measures.size() > 1;
    std::string head = two ? comparison_row("search", "machines", "its front", "of all fronts")
                           : comparison_row("search", "machines", optimum.measures.front(), "found with");
    std::string out = painted(Paint::heading, head) + "\n";
    if (!two)
        out += without_blanks_behind(print_start(optimum.start)) + "\n";
    const std::set<Costs> joint = costs_on_front(optimum.together());
    for (const SearchCourse& course : optimum.courses)
        out += print_course(course, joint) + "\n";
    return out;
}

std::string print_paths(const std::vector<PathPart>& start, const std::vector<PathPart>& best) {
    std::map<std::string, std::pair<double, double>> by_name;
    const std::vector<PathShare> of_start = shares_by_array(start), of_best = shares_by_array(best);
    for (const PathShare& share : of_start)
        by_name[name_of(share)].first += in_milliseconds(share.time);
    for (const PathShare& share : of_best)
        by_name[name_of(share)].second += in_milliseconds(share.time);
    std::vector<std::pair<std::string, std::pair<double, double>>> rows(by_name.begin(), by_name.end());
    std::ranges::stable_sort(rows, std::greater(),
                             [](const auto& row) { return std::abs(row.second.first - row.second.second); });
    std::string out = painted(Paint::heading, fmt::format("{:>12}  {:>12}  {:>12}  {}\n", "as it is", "the best", "ms",
                                                          "on the critical path"));
    std::pair<double, double> rest{sum_of(of_start), sum_of(of_best)}, whole = rest;
    for (std::size_t i = 0; i < std::min(rows.size(), most_path_rows); ++i) {
        const auto& [name, times] = rows[i];
        out += print_path_row(times.first, times.second, name);
        rest = {rest.first - times.first, rest.second - times.second};
    }
    if (rows.size() > most_path_rows)
        out += print_path_row(rest.first, rest.second, "everything else");
    return out + print_path_row(whole.first, whole.second, "the whole run");
}

std::string command_of(const Study& study, const Overrides& settings) {
    std::string out = program_name() + " run " + shell_word(study.netlist);
    for (const auto& [name, value] : settings)
        out += option("--set", name + "=" + value);
    for (const std::filesystem::path& folder : study.read.include_folders)
        out += option("-I", folder.string());
    for (const auto& [program, kind] : study.read.programs)
        out += option("--use", program + "=" + kind);
    for (const std::string& fault : study.read.faults)
        out += option("--fault", fault);
    return out + option("--seed", std::to_string(study.first_seed));
}

std::string print_why_none(const SearchCourse& course) {
    std::vector<std::pair<std::string, Infeasible>> reasons(course.why.begin(), course.why.end());
    std::ranges::stable_sort(reasons, std::greater(), [](const auto& each) { return each.second.machines; });
    std::string out = fmt::format("of {}, none can be built and completes its runs:",
                                  counted(course.tried.size(), "machine that was tried", "machines that were tried"));
    if (reasons.size() == 1)
        return out + "\n" + reasons.front().second.said;
    for (std::size_t i = 0; i < std::min(reasons.size(), most_reasons); ++i)
        out += fmt::format("\n{:>6}  {}", reasons[i].second.machines, reasons[i].first);
    return out;
}

} // namespace placedpar
