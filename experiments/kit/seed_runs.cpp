#include "experiments/kit/seed_runs.hpp"

#include "experiments/kit/experiment_runs.hpp"
#include "explore/study/sweep.hpp"
#include "explore/workers.hpp"
#include "text/number.hpp"
#include "text/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace placedpar {

namespace {

/// Names the figures by their indices, such that sorting the names keeps the order of the figures. If a figure is not
/// finite, its unit holds its text, such as "nan".
StudyFigures with_names(const Figures& figures) {
    StudyFigures named;
    for (double figure : figures)
        named[fmt::format("{:06}", named.size())] =
            std::isfinite(figure) ? StudyFigure{figure, ""} : StudyFigure{0, fmt::format("{}", figure)};
    return named;
}

Figures without_names(const StudyFigures& named) {
    Figures figures;
    for (const auto& each : named)
        figures.push_back(each.second.unit.empty() ? each.second.value
                                                   : parse_number<double>(each.second.unit).value());
    return figures;
}

} // namespace

Seeds seeds_of(const ReplayContext& context) { return record_seeds(context.seed, context.seeds); }

std::vector<Figures> run_seeds(const ReplayContext& context, const std::string& what,
                               const std::function<Figures(std::uint64_t seed)>& run) {
    const Seeds seeds = seeds_of(context);
    Study study;
    study.function = [&](const StudyRun& each) { return with_names(run(seeds[each.seed])); };
    study.products = {{.axes = {{"run", {StudyValues("run", fmt::format("\"{}\"", what))}}}}};
    study.first_seed = 0; // the study's seeds are indices in `seeds`
    study.seeds = seeds.size();
    StudySweep sweep(study, context.results);
    const std::size_t missing = sweep.missing().runs;
    auto show = [&](std::uint64_t ended) {
        context.progress(fmt::format("{}: {} of {} seeds", what, seeds.size() - missing + ended, seeds.size()));
    };
    show(0);
    sweep.run(std::min(count_cores(), missing), context.interruption, show);
    end_if_requested(context.interruption);
    std::vector<Figures> all;
    for (std::size_t i = 0; i < seeds.size(); ++i)
        all.push_back(without_names(context.results.find(*study.at(i))->figures));
    return all;
}

std::vector<double> column(const std::vector<Figures>& runs, std::size_t index) {
    std::vector<double> values;
    for (const Figures& figures : runs)
        values.push_back(figures[index]);
    return values;
}

double lower_median_of(const std::vector<Figures>& runs, std::size_t index) {
    return lower_median(column(runs, index));
}

} // namespace placedpar
