#include "experiments/kit/bootstrap.hpp"
#include "experiments/kit/experiment.hpp"
#include "experiments/kit/seed_runs.hpp"
#include "hydraulics/plant/record_scenario.hpp"
#include "identification/whole_search.hpp"
#include "report/cell.hpp"
#include "runtime/random.hpp"
#include "text/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

using namespace hydraulics;
using namespace identification;

namespace {

/// A compliance of the measured machine's drain side, and a leak into this side (0: no leak).
struct DrainCase {
    const char* name;
    double outlet_in3_per_psi, leak_in3_per_s_psi;
};
constexpr std::array drain_cases{DrainCase{"C_o 0.006", 0.006, 0}, DrainCase{"C_o 0.003", 0.003, 0},
                                 DrainCase{"C_o 0.012", 0.012, 0}, DrainCase{"0.006, a leak of 0.004", 0.006, 0.004}};

struct DrainFigure {
    enum : std::size_t { off_percent, flagged, limit_percent };
};

Figures identify_drain(const DrainCase& drain, const char* noise, std::uint64_t seed) {
    Parameters machine = Parameters::excavator();
    for (Parameter& row : noise_rows(machine, noise))
        machine.put(std::move(row));
    machine.set("boom.outlet_compliance", drain.outlet_in3_per_psi);
    machine.set("fault.leak", drain.leak_in3_per_s_psi);
    RandomStream sensors(seed, "sensors");
    const Record record = record_scenario_named("excavator")->make(machine, {}, [&] { return sensors.uniform(); });
    const Question question{.spool_offset_in = {}, .side = Side::outlet};
    const WholeWay whole = whole_way(1, Side::outlet);
    const ComplianceSearch prepared = prepare(record, Parameters::excavator(), question, whole.way);
    const Identified found = identify_whole(prepared, whole, seed);
    const LinkIdentified& link = found.links.front();
    return {100 * (link.compliance_in3_per_psi / drain.outlet_in3_per_psi - 1), found.flagged() ? 1. : 0.,
            100 * link.standard_error / drain.outlet_in3_per_psi};
}

/// The greatest standard error with which 95 % of normally distributed answers are within 10 %.
constexpr double greatest_error_percent = 10 / 1.96;
/// The greatest share of seeds in which the answer may be off by more than 10 % without a flag (our choice).
constexpr double most_missed = 0.01;

void add_drain(Comparison& comparison, const DrainCase& drain, const std::vector<Figures>& runs) {
    const bool judged = comparison.judged && drain.leak_in3_per_s_psi == 0;
    auto count = [&](auto holds) { return static_cast<std::size_t>(std::ranges::count_if(runs, holds)); };
    auto off = [](const Figures& run) { return std::abs(run[DrainFigure::off_percent]) > 10; };
    auto plain = [&](const char* row, const char* unit, double value) {
        comparison.add(plain_cell(row, drain.name, unit, value, 1));
    };
    const double least_error = lower_median_of(runs, DrainFigure::limit_percent);
    Cell within = share_cell("within 10 %", drain.name, runs.size() - count(off), runs.size());
    comparison.add(judged && least_error <= greatest_error_percent ? at_least(95, within) : within);
    const Interval share = success_interval(runs.size() - count(off), runs.size());
    plain("  from", "%", share.low);
    plain("  to", "%", share.high);
    const std::vector<double> errors = column(runs, DrainFigure::off_percent);
    const Interval median = median_interval(errors);
    plain("error, median", "% of C_o", lower_median(errors));
    plain("  from ", "% of C_o", median.low);
    plain("  to ", "% of C_o", median.high);
    plain("least standard error that the noise allows, median", "% of C_o", least_error);
    plain("flagged", "%", 100 * mean(column(runs, DrainFigure::flagged)));
    auto silent = [&](const Figures& run) { return off(run) && run[DrainFigure::flagged] == 0; };
    Cell missed =
        plain_cell("off by more than 10 %, without a flag", drain.name, "seeds", static_cast<double>(count(silent)), 0);
    comparison.add(judged ? at_most(most_missed * static_cast<double>(runs.size()), missed) : missed);
}

Replay replay_drain_side(const ReplayContext& context) {
    std::vector<Comparison> comparisons;
    for (const char* noise : {"none", "low", "mid"}) {
        Comparison comparison{.name = fmt::format("{} noise, {} seeds of the measured machine", noise, context.seeds),
                              .notes = "from, to: 95 % interval\n",
                              .against = "asked",
                              .judged = std::string_view(noise) != "mid"};
        for (const DrainCase& drain : drain_cases)
            add_drain(comparison, drain,
                      run_seeds(context, fmt::format("{}, {} noise", drain.name, noise),
                                [&](std::uint64_t seed) { return identify_drain(drain, noise, seed); }));
        comparisons.push_back(std::move(comparison));
    }
    return replay_of(std::move(comparisons), {});
}

} // namespace

extern const Experiment drain_side_experiment{
    .name = "drain-side",
    .about = "the compliance C_o of the drain side, by equation 3.4",
    .chapter = "3",
    .number = 10,
    .run = replay_drain_side,
    .seeds = 100,
};

} // namespace placedpar
