#include "identification/on_line/cross_check.hpp"

#include "identification/on_line/population_sets.hpp"
#include "identification/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace placedpar::identification {

using namespace hydraulics;

namespace {

// Pump 1 feeds bucket and boom, pump 2 swing and stick; through the cross-over each may feed others too.
constexpr std::array<LinkSet, 2> branches{LinkSet{Link::bucket, Link::boom}, LinkSet{Link::stick, Link::swing}};

/// A leak of 5 to 10 % of the flow raises the apparent compliance by 13 to 27 %, one of 14 % by up to 37 % (found by
/// simulation; equation 2.8 is its lower bound).
constexpr double most_of_a_leak = 0.40;

enum class State : unsigned char { unknown, good, off };

struct Verdict {
    State state = State::unknown;
    double ratio = 1; ///< to the baseline, median over the sets
};

Verdict judge(const LinkCheck& check, const DiagnosisSettings& settings) {
    if (!check.baseline_in3_per_psi)
        return {};
    std::vector<double> ratios;
    for (const SetEstimate& each : check.estimates)
        if (each.transients >= settings.transients)
            ratios.push_back(each.lasting_in3_per_psi / *check.baseline_in3_per_psi);
    if (ratios.empty())
        return {};
    auto off = [&](double ratio) { return std::abs(ratio - 1) > settings.off_by; };
    bool one_way = std::ranges::all_of(ratios, [](double r) { return r > 1; }) ||
                   std::ranges::all_of(ratios, [](double r) { return r < 1; });
    return {std::ranges::all_of(ratios, off) && one_way ? State::off : State::good, median(ratios)};
}

std::string percent(double ratio) { return fmt::format("{:+.0f} %", 100 * (ratio - 1)); }

Alarm alone_off(Link link, double ratio, bool others_known) {
    std::string where =
        others_known ? "the other link of its branch is not off"
                     : "the rest of its branch is not yet known: the branch's pump or spool may be at fault instead";
    bool leak = ratio > 1 && ratio <= 1 + most_of_a_leak;
    return {leak ? AlarmKind::leak : AlarmKind::link_fault,
            {link},
            fmt::format("{} is off by {} in all its population sets: {}; {}", name_of(link), percent(ratio),
                        leak ? "a leak of its hose or cylinder would look like this" : "look at its hose and cylinder",
                        where)};
}

void check_one(Link link, const LinkCheck& check, const DiagnosisSettings& settings, std::vector<Alarm>& alarms) {
    if (check.baseline_in3_per_psi && !check.estimates.empty())
        if (double ratio = check.newest().compliance_in3_per_psi / *check.baseline_in3_per_psi;
            ratio >= settings.doubled_at)
            alarms.push_back(
                {AlarmKind::doubled,
                 {link},
                 fmt::format("the compliance of {} is {:.2f} times its baseline, by {}: air in the oil, or a "
                             "hose that gives",
                             name_of(link), ratio, name_of_set(check.newest().set))});
    if (check.spread() > settings.inconsistent_over)
        alarms.push_back({AlarmKind::inconsistent,
                          {link},
                          fmt::format("{} population sets disagree on {} by {:.0f} %", check.estimates.size(),
                                      name_of(link), 100 * check.spread())});
    if (check.at_lower_bound)
        alarms.push_back({AlarmKind::drift,
                          {link},
                          fmt::format("{} is at the lower bound: an offset of the spool reading, or drift of voltage "
                                      "against spool, makes the compliance negative; calibrate the offset",
                                      name_of(link))});
}

void check_branch(LinkSet branch, const PerLink<Verdict>& verdicts, std::vector<Alarm>& alarms) {
    std::vector<Link> links = links_of(branch);
    auto count = [&](State state) {
        return std::ranges::count_if(links, [&](Link link) { return verdicts[index_of(link)].state == state; });
    };
    if (count(State::off) == std::ssize(links)) {
        alarms.push_back({AlarmKind::branch_fault, branch,
                          fmt::format("{} ({}) and {} ({}) are off in all their population sets: look at what they "
                                      "share, their pump's flow and the offset of the spools",
                                      name_of(links[0]), percent(verdicts[index_of(links[0])].ratio), name_of(links[1]),
                                      percent(verdicts[index_of(links[1])].ratio))});
        return;
    }
    for (Link link : links)
        if (const Verdict& verdict = verdicts[index_of(link)]; verdict.state == State::off)
            alarms.push_back(alone_off(link, verdict.ratio, count(State::good) > 0));
}

} // namespace

std::string_view name_of(AlarmKind kind) {
    constexpr std::array<std::string_view, 6> names{"doubled", "inconsistent", "drift",
                                                    "leak",    "link_fault",   "branch_fault"};
    return names[static_cast<std::size_t>(kind)];
}

double LinkCheck::spread() const {
    if (estimates.size() < 2)
        return 0;
    std::vector<double> values;
    for (const SetEstimate& each : estimates)
        values.push_back(each.compliance_in3_per_psi);
    auto [least, greatest] = std::ranges::minmax(values);
    double middle = median(values);
    return middle > 0 ? (greatest - least) / middle : 1;
}

const SetEstimate& LinkCheck::newest() const {
    assert(!estimates.empty());
    return *std::ranges::max_element(estimates, {}, &SetEstimate::time_s);
}

std::vector<Alarm> find_alarms(const PerLink<LinkCheck>& checks, const DiagnosisSettings& settings) {
    std::vector<Alarm> alarms;
    PerLink<Verdict> verdicts;
    for (Link link : all_links) {
        check_one(link, checks[index_of(link)], settings, alarms);
        verdicts[index_of(link)] = judge(checks[index_of(link)], settings);
    }
    for (LinkSet branch : branches)
        check_branch(branch, verdicts, alarms);
    std::ranges::stable_sort(alarms, {}, &Alarm::kind);
    return alarms;
}

} // namespace placedpar::identification
