#include "experiments/chapter_3/kit/verdict_study.hpp"

#include "experiments/kit/bootstrap.hpp"
#include "experiments/kit/seed_runs.hpp"
#include "identification/on_line/diagnosis_state.hpp"
#include "identification/verdict/way_matrices.hpp"
#include "text/interval.hpp"

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

std::vector<TestedFault> tested_faults(const RecordSource& source, AreasFrom from) {
    const bool rest_follows = source.has_servo;
    std::vector<TestedFault> faults{{{"C +20 %", {}}, 1.2, AlarmKind::compliance}};
    auto add = [&](PlantFault fault, AlarmKind called) -> TestedFault& {
        return faults.emplace_back(TestedFault{std::move(fault), 1, called});
    };
    auto add_shared = [&](PlantFault fault, AlarmKind called, double units = 1) {
        TestedFault& added = add(std::move(fault), called);
        added.units = units;
        if (!rest_follows)
            added.most_undecided.reset();
    };
    add(parameter("leak of 5 %", "fault.leak", 0.0014), AlarmKind::leak);
    faults.push_back({parameter("leak of 10 %", "fault.leak", 0.0028), 1, AlarmKind::leak, false, 2, 99, 99});
    if (from != AreasFrom::areas) {
        add_shared(leak_of("leak of 5 % that begins", 0.0014), AlarmKind::leak);
        add_shared(leak_of("leak of 10 % that begins", 0.0028), AlarmKind::leak, 2);
    }
    if (from == AreasFrom::spool) {
        add_shared(parameter("offset of +.005 in", "fault.spool_offset", 0.005), AlarmKind::offset);
        add_shared(parameter("offset of -.005 in", "fault.spool_offset", -0.005), AlarmKind::offset);
    } else if (from == AreasFrom::servo) {
        add(parameter("drift of +10.5 mV", "fault.servo_bias", 0.0105), AlarmKind::drift);
        add(parameter("drift of -10.5 mV", "fault.servo_bias", -0.0105), AlarmKind::drift);
    }
    faults.push_back({{"C doubled from the first day", {}}, 2, AlarmKind::compliance, true});
    faults.push_back({parameter("leak of 10 % from the first day", "fault.leak", 0.0028), 1, AlarmKind::leak, true});
    return faults;
}

namespace {

Outcome outcome_of(std::size_t movements, const Alarm& first, const TestedFault& fault) {
    const bool undecided =
        fault.called != AlarmKind::compliance && first == Alarm{AlarmKind::leak_or_offset, {Link::boom}, {}};
    return {movements, first == Alarm{fault.called, {Link::boom}, {}}, undecided};
}

} // namespace

Outcome watch(TestedMachine machine, const TestedFault& fault, std::size_t movements, std::uint64_t first_number) {
    for (std::size_t i = 1; i <= movements; ++i) {
        machine.move(fault.fault, fault.compliance_factor, first_number + i);
        if (!machine.alarms().empty())
            return outcome_of(i, machine.alarms().front(), fault);
    }
    return {};
}

namespace {

/// Returns a copy of the judge (the part of the machine's diagnosis that decides about faults) for the boom.
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
        throw std::runtime_error(
            fmt::format("the diagnosis has no baseline after {} movements of a sound machine", most));
    return number;
}

namespace {

/// Returns the expected logarithm of the likelihood ratio of two hypotheses, "one unit of the fault" and "no fault",
/// after `faulty_movements` movements. Assumes that these movements are as informative as the first movements, that the
/// standard errors stated for the first movements are right, and that the link has no other fault.
double evidence_of(const LinkJudge& judge, LinkFault fault) {
    const WayVector unit = vector_of(unit_of(fault));
    double known = 0;
    for (const Deviation& each : judge.state().first)
        known += unit.dot(matrix_of(each.information()) * unit);
    known *= static_cast<double>(faulty_movements) / static_cast<double>(judge.state().first.size());
    const double unknown = 1 / unit.dot(matrix_of(judge.baseline()->covariance).inverse() * unit);
    return known / 2 / (1 + known * unknown);
}

LinkFault fault_of(const TestedFault& fault) {
    if (fault.called == AlarmKind::compliance)
        return LinkFault::compliance;
    if (fault.called != AlarmKind::leak)
        return LinkFault::offset;
    return fault.fault.parameters.size() > 1 ? LinkFault::new_leak : LinkFault::leak; // a second parameter is the time
                                                                                      // at which the leak begins
}

/// Returns the figures of one machine. The first is the number of movements until a false alarm (0: no alarm). Then
/// evidence_of() follows for each of `all_faults`. Then three figures follow for each of tested_faults(): the number of
/// movements until the fault is found (0: never), whether it is named correctly, and whether it is left undecided.
Figures judge_machine(const RecordSource& source, AreasFrom from, std::uint64_t seed) {
    const TestedMachine new_machine(source, from, seed);
    const TestedFault sound{no_fault(), 1, {}};
    TestedMachine known = new_machine;
    const std::uint64_t next = make_known(known);
    Figures figures{static_cast<double>(watch(known, sound, sound_movements, next).found_after)};
    for (LinkFault each : all_faults)
        figures.push_back(evidence_of(judge_of(known), each));
    std::uint64_t number = next + sound_movements; // differs from fault to fault, and so do the movements
    for (const TestedFault& fault : tested_faults(source, from)) {
        const Outcome outcome = watch(fault.from_first_day ? new_machine : known, fault, faulty_movements, ++number);
        figures.push_back(static_cast<double>(outcome.found_after));
        figures.push_back(outcome.called);
        figures.push_back(outcome.undecided);
        number += faulty_movements;
    }
    return figures;
}

constexpr std::size_t sound_figure = 0, evidence_figure = 1, first_fault_figure = evidence_figure + all_faults.size();

std::size_t count(const std::vector<double>& values) {
    return values.size() - static_cast<std::size_t>(std::ranges::count(values, 0.0));
}

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

/// The highest percentage of faults that any test can find, and its 95 % interval. The interval is needed because the
/// simulated machines are a sample of all machines.
struct Limit {
    double percent;
    Interval interval;
};

/// Returns the limit for tests that raise an alarm for 1 % of the sound machines. The most powerful of these tests is
/// the likelihood-ratio test (J. Neyman and E. Pearson, 1933). The logarithm of the ratio is normally distributed, and
/// its variance is twice its mean.
Limit limit_of(const TestedFault& fault, const std::vector<Figures>& machines) {
    if (fault.from_first_day)
        return {100, {100, 100}};
    constexpr double one_in_a_hundred = 2.326; // in standard deviations
    std::vector<double> found;
    for (double of_unit : column(machines, evidence_figure + static_cast<std::size_t>(fault_of(fault)))) {
        const double beyond = std::sqrt(2 * of_unit) * fault.units - one_in_a_hundred;
        found.push_back(100 * std::erfc(-beyond / std::sqrt(2.0)) / 2);
    }
    return {sum(found) / static_cast<double>(found.size()),
            quotient_interval(found, std::vector<double>(found.size(), 1))};
}

struct FaultFigures {
    std::vector<double> found, called, undecided;
};

void add_fault(Comparison& comparison, const TestedFault& fault, const std::string& noise, AreasFrom from,
               const Limit& limit, const FaultFigures& of) {
    const std::string name = fault.fault.name;
    const std::size_t faults = count(of.found), called = count(of.called), undecided = count(of.undecided);
    const Cell share = share_cell(name + ": found", noise, faults, of.found.size());
    comparison.add(limit.interval.low >= fault.least_found ? at_least(fault.least_found, share) : share);
    if (!fault.from_first_day)
        comparison.add(plain_cell(name + ": limit by theory", noise, "%", limit.percent, 1));
    comparison.add(at_least(fault.least_called, share_cell(name + ": found and named correctly, or undecided", noise,
                                                           called + undecided, faults)));
    if (fault.called != AlarmKind::compliance && from != AreasFrom::areas) {
        const Cell share = share_cell(name + ": found but undecided", noise, undecided, faults);
        comparison.add(fault.most_undecided ? at_most(*fault.most_undecided, share) : share);
    }
    if (faults > 0)
        comparison.add(plain_cell(name + ": movements until it is found", noise, "",
                                  sum(of.found) / static_cast<double>(faults), 1));
}

void add_noise(Comparison& comparison, const RecordSource& source, AreasFrom from,
               const std::vector<Figures>& machines) {
    const std::string noise = std::string(source.noise) + " noise";
    const std::size_t false_alarms = count(column(machines, sound_figure));
    comparison.add(at_most(1, share_cell("sound machines with an alarm", noise, false_alarms, machines.size())));
    comparison.add(plain_cell("sound machines with an alarm, upper bound (95 %)", noise, "%",
                              success_interval(false_alarms, machines.size()).high, 1));
    std::size_t figure = first_fault_figure;
    for (const TestedFault& fault : tested_faults(source, from)) {
        add_fault(comparison, fault, noise, from, limit_of(fault, machines),
                  {column(machines, figure), column(machines, figure + 1), column(machines, figure + 2)});
        figure += 3;
    }
}

} // namespace

Comparison verdict_comparison(const ReplayContext& context, const char* machine, const RecordSource& source,
                              AreasFrom from) {
    const char* by = from == AreasFrom::areas ? "areas" : from == AreasFrom::spool ? "the spool" : "the voltage";
    const std::string name = fmt::format("{} by {}", machine, by);
    Comparison comparison{
        .name = fmt::format("on-line verdicts: {}, {} machines of each kind", name, context.seeds),
        .notes = std::string("found and named correctly, found but undecided: in % of those found\nlimit by theory: a "
                             "test that gives 1 % "
                             "of the sound machines an alarm cannot find more of the faults in 8 movements\n") +
                 (source.has_servo || from == AreasFrom::areas
                      ? ""
                      : "these records end while oil flows, so a leak that begins with a movement and an offset change "
                        "the flow alike (correlation .999): both may be left undecided\n"),
        .against = "known",
        .judged = true};
    for (const char* noise : tested_noises) {
        RecordSource with_noise = source;
        with_noise.noise = noise;
        add_noise(comparison, with_noise, from,
                  run_seeds(context, fmt::format("{}, {} noise", name, noise),
                            [&](std::uint64_t seed) { return judge_machine(with_noise, from, seed); }));
    }
    return comparison;
}

} // namespace placedpar
