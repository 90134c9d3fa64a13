#include "experiments/chapter_3/kit/rate_study.hpp"

#include "experiments/chapter_3/kit/verdict_study.hpp"
#include "experiments/kit/seed_runs.hpp"
#include "text/interval.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

using namespace hydraulics;
using namespace identification;

PlantFault long_movement(const RecordSource& source) {
    if (source.has_servo)
        return {"sound, twelve seconds", {{"excavator.second_time", 12.1}, {"excavator.duration", 12.8}}};
    return {"sound, twelve seconds", {{"scenario_a.duration", 12.1}}};
}

namespace {

/// Returns whether the diagnosis raises an alarm for a sound machine.
bool accused(const RecordSource& source, AreasFrom from, std::uint64_t seed) {
    TestedMachine machine(source, from, seed);
    machine.move(long_movement(source), 1, 0);
    bool accused = !machine.alarms().empty();
    for (std::uint64_t number = 1; number <= sound_movements && !accused; ++number) {
        machine.move(no_fault(), 1, number);
        accused = !machine.alarms().empty();
    }
    machine.move(long_movement(source), 1, sound_movements + 1);
    return accused || !machine.alarms().empty();
}

/// Returns the figures of one machine. The first says whether the diagnosis raises an alarm while the machine is sound.
/// Two figures follow for each fault: whether the fault is found, and whether it is named correctly or left undecided.
Figures judge_at_rate(const RecordSource& source, AreasFrom from, bool with_faults, std::uint64_t seed) {
    Figures figures{static_cast<double>(accused(source, from, seed))};
    if (!with_faults)
        return figures;
    const TestedMachine new_machine(source, from, seed);
    TestedMachine known = new_machine;
    std::uint64_t number = make_known(known);
    for (const TestedFault& fault : tested_faults(source, from)) {
        const Outcome outcome = watch(fault.from_first_day ? new_machine : known, fault, faulty_movements, ++number);
        figures.push_back(outcome.found_after > 0);
        figures.push_back(outcome.called || outcome.undecided);
        number += faulty_movements;
    }
    return figures;
}

std::size_t count_in(const std::vector<Figures>& machines, std::size_t figure) {
    return static_cast<std::size_t>(std::ranges::count(column(machines, figure), 1.0));
}

void add_share(Comparison& comparison, const std::string& row, const std::string& rate, std::size_t of, std::size_t all,
               std::optional<double> least) {
    const Cell share = share_cell(row, rate, of, all);
    comparison.add(least ? at_least(*least, share) : share);
    const Interval within = success_interval(of, all);
    comparison.add(plain_cell(row + ", from", rate, "%", within.low, 1));
    comparison.add(plain_cell(row + ", to", rate, "%", within.high, 1));
}

void add_rate(Comparison& comparison, const LoggerRate& rate, const RecordSource& source, AreasFrom from,
              const std::vector<Figures>& machines) {
    const std::size_t alarms = count_in(machines, 0), all = machines.size();
    comparison.add(at_most(1, share_cell("sound machines with an alarm", rate.name, alarms, all)));
    comparison.add(plain_cell("sound machines with an alarm, upper bound (95 %)", rate.name, "%",
                              success_interval(alarms, all).high, 1));
    if (!rate.with_faults)
        return;
    std::size_t figure = 1;
    for (const TestedFault& fault : tested_faults(source, from)) {
        const std::string name = fault.fault.name;
        const std::size_t found = count_in(machines, figure);
        add_share(comparison, name + ": found", rate.name, found, all, fault.least_found);
        if (found > 0)
            add_share(comparison, name + ": found and named correctly, or undecided", rate.name,
                      count_in(machines, figure + 1), found, fault.least_called);
        figure += 2;
    }
}

} // namespace

Comparison rate_comparison(const ReplayContext& context, const char* machine, const RecordSource& source,
                           AreasFrom from) {
    const std::string name =
        fmt::format("{} by the {}, {} noise", machine, from == AreasFrom::spool ? "spool" : "voltage", source.noise);
    Comparison comparison{
        .name = fmt::format("loggers of several rates: {}, {} machines of each kind", name, context.seeds),
        .notes = "found and named correctly: in % of those found; from, to: 95 % interval (Clopper and Pearson)\n",
        .against = "known",
        .judged = true};
    for (const LoggerRate& rate : logger_rates) {
        RecordSource at_rate = source;
        at_rate.period_s = rate.period_s;
        add_rate(comparison, rate, at_rate, from,
                 run_seeds(context, fmt::format("{}, {}", name, rate.name),
                           [&](std::uint64_t seed) { return judge_at_rate(at_rate, from, rate.with_faults, seed); }));
    }
    return comparison;
}

} // namespace placedpar
