#include "experiments/kit/experiment.hpp"
#include "experiments/kit/seed_runs.hpp"
#include "hydraulics/plant/excavator_record.hpp"
#include "hydraulics/plant/excavator_values.hpp"
#include "hydraulics/plant/record_scenario.hpp"
#include "identification/whole_search.hpp"
#include "report/cell.hpp"
#include "runtime/random.hpp"
#include "text/interval.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

using namespace hydraulics;
using namespace identification;

namespace {

/// The largest group of coupled links in a configuration; all links of the group move.
struct CoupledMotion {
    Configuration configuration;
    LinkSet links;
    std::string name; ///< "c: bucket, boom, stick"
    ExcavatorScenario scenario;
    ExcavatorMotion motion;
};

std::vector<Link> coupled_members(LinkSet set) {
    std::vector<Link> members;
    for (Link link : all_links)
        if (set.contains(link))
            members.push_back(link);
    return members;
}

CoupledMotion simulate_coupled(Configuration configuration) {
    const auto groups = coupled_groups(configuration);
    const LinkSet links =
        *std::ranges::max_element(groups, {}, [](LinkSet group) { return coupled_members(group).size(); });
    std::string name(1, name_of(configuration));
    for (Link link : coupled_members(links))
        name += fmt::format("{} {}", name.size() == 1 ? ":" : ",", name_of(link));
    ExcavatorScenario scenario = step_scenario(configuration, links, Parameters::excavator());
    ExcavatorMotion motion = simulate_excavator(scenario);
    return {configuration, links, std::move(name), std::move(scenario), std::move(motion)};
}

struct LinksLevel {
    const char *name, *noise;
    std::optional<std::size_t> samples; ///< nullopt: the whole movement
    bool judged;
};

constexpr LinksLevel links_levels[]{{"no noise, the thesis's window of 10 samples", "none", 10, true},
                                    {"low noise, the whole movement", "low", {}, true},
                                    {"mid noise, the whole movement", "mid", {}, false},
                                    {"high noise, the whole movement", "high", {}, false}};

struct LinksFigure {
    enum : std::size_t { within, silent, flagged, limit, generations, t800_s, t800_16_s };
};

/// Measures the motion with the sensor noise of a seed, and identifies all compliances.
Figures identify_coupled(const CoupledMotion& moving, const LinksLevel& level, std::uint64_t seed) {
    Parameters machine = Parameters::excavator();
    for (Parameter& row : noise_rows(machine, level.noise))
        machine.put(std::move(row));
    RandomStream sensors(seed, "sensors");
    const Record record = measure_excavator(moving.motion, moving.scenario, machine["sensors.period"],
                                            measurement_noise(machine), [&] { return sensors.uniform(); });
    WholeWay whole = whole_way(coupled_members(moving.links).size());
    whole.way.usable.count = level.samples.value_or(whole.way.usable.count);
    const ComplianceSearch prepared = prepare(record, machine, {moving.configuration, moving.links, {}, {}}, whole.way);
    const Identified found = identify_whole(prepared, whole, seed);
    double worst = 0, limit = 0;
    for (const LinkIdentified& link : found.links) {
        const double right = machine[fmt::format("{}.inlet_compliance", name_of(link.link))];
        worst = std::max(worst, std::abs(link.compliance_in3_per_psi / right - 1));
        limit = std::max(limit, 100 * link.standard_error / right);
    }
    const SearchCost cost = cost_of(whole, prepared.problem, found.generations, prepared.samples.size());
    return {worst <= 0.1 ? 1. : 0.,
            worst > 0.1 && !found.flagged() ? 1. : 0.,
            found.flagged() ? 1. : 0.,
            limit,
            static_cast<double>(found.generations),
            cost.seconds,
            cost.seconds_on_16};
}

void add_coupled_links(Comparison& comparison, const CoupledMotion& moving, bool judged,
                       const std::vector<Figures>& runs) {
    auto count = [&](std::size_t figure) {
        return static_cast<std::size_t>(std::ranges::count(column(runs, figure), 1.0));
    };
    auto share = [&](std::size_t figure) {
        return 100 * static_cast<double>(count(figure)) / static_cast<double>(runs.size());
    };
    auto cell = [&](const char* row, const char* unit, double value, int decimals) {
        return plain_cell(row, moving.name, unit, value, decimals);
    };
    const Cell right = cell("all links within 10 %", "% of seeds", share(LinksFigure::within), 0);
    comparison.add(judged ? at_least(95, right) : right);
    const Interval interval = success_interval(count(LinksFigure::within), runs.size());
    comparison.add(cell("  from", "% of seeds", interval.low, 0));
    comparison.add(cell("  to", "% of seeds", interval.high, 0));
    const Cell missed =
        cell("a link off by more than 10 %, without a flag", "% of seeds", share(LinksFigure::silent), 0);
    comparison.add(judged ? at_most(0, missed) : missed);
    comparison.add(cell("flagged", "% of seeds", share(LinksFigure::flagged), 0));
    comparison.add(
        cell("least standard error of the worst link, median", "%", lower_median_of(runs, LinksFigure::limit), 1));
    comparison.add(cell("generations", "", lower_median_of(runs, LinksFigure::generations), 0));
    comparison.add(cell("on one T800", "s", lower_median_of(runs, LinksFigure::t800_s), 0));
    comparison.add(cell("on 16 T800s", "s", lower_median_of(runs, LinksFigure::t800_16_s), 0));
}

Replay replay_links_at_once(const ReplayContext& context) {
    std::vector<CoupledMotion> motions;
    for (Configuration configuration : all_configurations)
        motions.push_back(simulate_coupled(configuration));
    std::vector<Comparison> comparisons;
    for (const LinksLevel& level : links_levels) {
        Comparison comparison{
            .name = fmt::format("{}, {} seeds", level.name, context.seeds),
            .notes = "from, to: 95 % interval (Clopper and Pearson)\nleast standard error: Cramer-Rao bound\n",
            .against = "asked",
            .judged = level.judged};
        for (const CoupledMotion& moving : motions)
            add_coupled_links(comparison, moving, level.judged,
                              run_seeds(context, fmt::format("{}, {}", level.name, moving.name),
                                        [&](std::uint64_t seed) { return identify_coupled(moving, level, seed); }));
        comparisons.push_back(std::move(comparison));
    }
    return replay_of(std::move(comparisons), {});
}

} // namespace

extern const Experiment links_at_once_experiment{
    .name = "links-at-once",
    .about = "one search for all links of each configuration: errors, the least standard error, and the cost",
    .chapter = "3",
    .number = 9,
    .run = replay_links_at_once,
    .seeds = 100,
};

} // namespace placedpar
