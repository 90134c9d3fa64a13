#include "experiments/chapter_3/kit/verdict_study.hpp"

#include "experiments/kit/interval.hpp"
#include "experiments/kit/seed_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace placedpar {

using namespace hydraulics;
using namespace identification;

namespace {

constexpr const char* tested_noises[]{"low", "mid", "high"};

PlantFault parameter(const char* name, const char* parameter, double value) { return {name, {{parameter, value}}}; }

} // namespace

/// The leaks are there from the start, unlike leak_of()'s. 10.5 mV move the spool by .005 in.
/// Whose valves are known by their areas can have neither.
std::vector<TestedFault> tested_faults(AreasFrom from) {
    const TestedFault doubled{{"C doubled from the first day", {}}, 2, AlarmKind::compliance, true};
    std::vector<TestedFault> faults{{{"C +20 %", {}}, 1.2, AlarmKind::compliance}};
    faults.push_back({parameter("leak of 5 %", "fault.leak", 0.0014), 1, AlarmKind::leak});
    faults.push_back({parameter("leak of 10 %", "fault.leak", 0.0028), 1, AlarmKind::leak, false, 2, 99, 99});
    auto add = [&](const char* name, const char* parameter_name, double value, AlarmKind called) {
        faults.push_back({parameter(name, parameter_name, value), 1, called});
    };
    if (from == AreasFrom::spool) {
        add("offset of +.005 in", "fault.spool_offset", 0.005, AlarmKind::offset);
        add("offset of -.005 in", "fault.spool_offset", -0.005, AlarmKind::offset);
    } else if (from == AreasFrom::servo) {
        add("drift of +10.5 mV", "fault.servo_bias", 0.0105, AlarmKind::drift);
        add("drift of -10.5 mV", "fault.servo_bias", -0.0105, AlarmKind::drift);
    }
    faults.push_back(doubled);
    faults.push_back({parameter("leak of 10 % from the first day", "fault.leak", 0.0028), 1, AlarmKind::leak, true});
    return faults;
}

Outcome watch(TestedMachine machine, const TestedFault& fault, std::size_t movements, std::uint64_t first_number) {
    for (std::size_t i = 1; i <= movements; ++i) {
        machine.move(fault.fault, fault.compliance_factor, first_number + i);
        if (!machine.alarms().empty())
            return {i, machine.alarms().front() == Alarm{fault.called, {Link::boom}, {}}};
    }
    return {};
}

namespace {

/// What is known of a machine's boom after its first movements.
LinkJudge judge_of(const TestedMachine& machine) {
    return LinkJudge(machine.diagnosis().state().watches.begin()->second.judges.back());
}

} // namespace

std::uint64_t make_known(TestedMachine& machine) {
    constexpr std::uint64_t most = 50;
    std::uint64_t number = 0;
    do
        machine.move(no_fault(), 1, number++);
    while (!judge_of(machine).baseline() && number < most);
    if (!judge_of(machine).baseline())
        throw std::runtime_error(fmt::format("{} movements do not tell how a sound machine is", most));
    return number;
}

namespace {

/// Of each way: the mean of the logarithm of the likelihood that a unit of it would have over none after the movements
/// within which it is to be found, were they as the first ones and the two other ways known to be sound. By the
/// standard errors as they are stated.
Eigen::Vector3d evidence_of(const LinkJudge& judge) {
    Eigen::Vector3d known = Eigen::Vector3d::Zero();
    for (const Deviation& each : judge.state().first)
        known += each.information().diagonal();
    known *= static_cast<double>(faulty_movements) / static_cast<double>(judge.state().first.size());
    const Eigen::Vector3d unknown = judge.baseline()->covariance.inverse().diagonal().cwiseInverse();
    return known.array() / 2 / (1 + known.array() * unknown.array());
}

/// Of one machine: movements until a false alarm, 0 for none; the evidence of the three ways; and of each fault
/// the movements until it is found, 0 for never, and whether it is called so.
Figures judge_machine(const RecordSource& source, AreasFrom from, std::uint64_t seed) {
    const TestedMachine new_machine(source, from, seed);
    const TestedFault sound{no_fault(), 1, {}};
    TestedMachine known = new_machine;
    const std::uint64_t next = make_known(known);
    Figures figures{static_cast<double>(watch(known, sound, sound_movements, next).found_after)};
    for (double each : evidence_of(judge_of(known)))
        figures.push_back(each);
    std::uint64_t number = next + sound_movements; // no two faults have the same movements
    for (const TestedFault& fault : tested_faults(from)) {
        const Outcome outcome = watch(fault.from_first_day ? new_machine : known, fault, faulty_movements, ++number);
        figures.push_back(static_cast<double>(outcome.found_after));
        figures.push_back(outcome.called);
        number += faulty_movements;
    }
    return figures;
}

constexpr std::size_t sound_figure = 0, evidence_figure = 1, first_fault_figure = 4;

std::size_t count(const std::vector<double>& values) {
    return values.size() - static_cast<std::size_t>(std::ranges::count(values, 0.0));
}

double percent(std::size_t of, std::size_t all) {
    return all == 0 ? 0 : 100 * static_cast<double>(of) / static_cast<double>(all);
}

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

/// The share of faults that no test can exceed which raises an alarm in 1 % of sound machines, in percent: that of the
/// likelihood ratio (J. Neyman and E. Pearson, 1933), whose logarithm is normal, its variance twice its mean.
double limit_percent(const TestedFault& fault, const std::vector<Figures>& machines) {
    constexpr double one_in_a_hundred = 2.326; // standard deviations
    const std::size_t way = fault.called == AlarmKind::compliance ? 0 : fault.called == AlarmKind::leak ? 1 : 2;
    double found = 0;
    for (double of_unit : column(machines, evidence_figure + way)) {
        const double beyond = std::sqrt(2 * of_unit) * fault.units - one_in_a_hundred;
        found += std::erfc(-beyond / std::sqrt(2.0)) / 2;
    }
    return 100 * found / static_cast<double>(machines.size());
}

void add_fault(Comparison& comparison, const TestedFault& fault, const std::string& noise, double limit,
               const std::vector<double>& found, const std::vector<double>& called) {
    const std::string name = fault.fault.name;
    const std::size_t faults = count(found);
    const Cell share = plain_cell(name + ": found", noise, "%", percent(faults, found.size()), 1);
    comparison.add(limit >= fault.least_found ? at_least(fault.least_found, share) : share);
    if (!fault.from_first_day)
        comparison.add(plain_cell(name + ": limit by theory", noise, "%", limit, 1));
    comparison.add(at_least(fault.least_called,
                            plain_cell(name + ": of those called so", noise, "%", percent(count(called), faults), 1)));
    if (faults > 0)
        comparison.add(
            plain_cell(name + ": movements it takes", noise, "", sum(found) / static_cast<double>(faults), 1));
}

void add_noise(Comparison& comparison, const std::string& noise, AreasFrom from, const std::vector<Figures>& machines) {
    const std::size_t false_alarms = count(column(machines, sound_figure));
    comparison.add(
        at_most(1, plain_cell("sound machines with an alarm", noise, "%", percent(false_alarms, machines.size()), 1)));
    comparison.add(plain_cell("sound machines: the upper bound of 95 %", noise, "%",
                              success_interval(false_alarms, machines.size()).high, 1));
    std::size_t figure = first_fault_figure;
    for (const TestedFault& fault : tested_faults(from)) {
        add_fault(comparison, fault, noise, fault.from_first_day ? 100 : limit_percent(fault, machines),
                  column(machines, figure), column(machines, figure + 1));
        figure += 2;
    }
}

} // namespace

Comparison verdict_comparison(const ReplayContext& context, const char* machine, const RecordSource& source,
                              AreasFrom from) {
    const char* by = from == AreasFrom::areas ? "areas" : from == AreasFrom::spool ? "the spool" : "the voltage";
    const std::string name = fmt::format("{} by {}", machine, by);
    Comparison comparison{
        .name = fmt::format("what is said on line: {}, {} machines", name, context.seeds),
        .notes = "limit by theory: no test finds more in 8 movements that wrongly accuses 1 % of the sound machines\n",
        .against = "known",
        .judged = true};
    for (const char* noise : tested_noises) {
        RecordSource with_noise = source;
        with_noise.noise = noise;
        add_noise(comparison, std::string(noise) + " noise", from,
                  run_seeds(context, fmt::format("{}, {} noise", name, noise),
                            [&](std::uint64_t seed) { return judge_machine(with_noise, from, seed); }));
    }
    return comparison;
}

} // namespace placedpar
