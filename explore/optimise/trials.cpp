#include "explore/optimise/trials.hpp"

#include "explore/study/sweep.hpp"
#include "runtime/kernel.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace placedpar {

Study study_of(const Study& study, const std::vector<Overrides>& all) {
    Study some{.netlist = study.netlist,
               .read = study.read,
               .products = {},
               .first_seed = study.first_seed,
               .seeds = study.seeds,
               .until = study.until,
               .measures = study.measures};
    some.prices = study.prices;
    for (const Overrides& settings : all) {
        StudyProduct& product = some.products.emplace_back();
        for (const auto& [name, value] : settings)
            product.axes.push_back({name, {StudyValues(name, value)}});
    }
    return some;
}

MachineTrials::MachineTrials(const Study& study, const MachineSpace& space, StudyResults& results, std::size_t workers,
                             Interruption& interruption)
    : study_(study), space_(space), results_(results), workers_(workers), interruption_(interruption),
      costs_(study.search->minimise.begin(), study.search->minimise.end()), found_(costs_.size()) {}

bool MachineTrials::try_out(std::span<const std::uint64_t> machines, const std::function<void(std::uint64_t)>& show) {
    std::vector<std::uint64_t> fresh;
    std::vector<Overrides> settings;
    for (std::uint64_t machine : machines) {
        if (trials_.contains(machine))
            continue;
        if (!space_.holds(machine)) {
            trials_[machine].why = "the study's condition \"where\" is not met";
        } else if (std::ranges::find(fresh, machine) == fresh.end()) {
            fresh.push_back(machine);
            settings.push_back(space_.settings(machine));
        }
    }
    if (!make_runs(settings, show))
        return false;
    for (std::size_t i = 0; i < fresh.size(); ++i)
        trials_[fresh[i]] = trial_of(settings[i]);
    return true;
}

const Trial& MachineTrials::of(std::uint64_t machine) { return trials_.at(machine); }

std::optional<Trial> MachineTrials::of(const Overrides& settings) {
    if (!make_runs({settings}, [](std::uint64_t) {}))
        return std::nullopt;
    return trial_of(settings);
}

bool MachineTrials::make_runs(const std::vector<Overrides>& settings, const std::function<void(std::uint64_t)>& show) {
    if (settings.empty() || interruption_.requested())
        return !interruption_.requested();
    const Study some = study_of(study_, settings);
    StudySweep(some, results_).run(workers_, interruption_, show);
    return !interruption_.requested();
}

Trial MachineTrials::trial_of(const Overrides& settings) {
    Trial trial{.merit = {.feasible = true, .costs = std::vector<double>(costs_.size())}};
    for (std::uint64_t i = 0; i < study_.seeds && trial.why.empty(); ++i) {
        StudyOutcome outcome = results_.find({settings, study_.first_seed + i}).value();
        trial.simulated |= outcome.refused.empty();
        if (!outcome.refused.empty())
            trial.why = outcome.refused;
        else if (outcome.ended != name_of(RunOutcome::completed))
            trial.why = outcome.ended;
        else
            add_figures(trial, outcome.figures);
    }
    if (!trial.why.empty())
        trial.merit = {};
    return trial;
}

void MachineTrials::add_figures(Trial& trial, const StudyFigures& figures) {
    if (!any_)
        any_ = figures;
    for (std::size_t i = 0; i < costs_.size(); ++i)
        if (std::optional<StudyFigure> figure = costs_[i].of(figures)) {
            trial.merit.costs[i] += figure->value / static_cast<double>(study_.seeds);
            found_[i] = true;
        } else {
            trial.why = fmt::format("a run did not measure {}", costs_[i].text());
        }
}

void MachineTrials::require_measures() const {
    for (std::size_t i = 0; any_ && i < costs_.size(); ++i)
        if (!found_[i])
            throw UserError(there_is_no_measure(costs_[i], *any_));
}

} // namespace placedpar
