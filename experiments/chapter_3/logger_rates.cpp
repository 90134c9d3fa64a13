#include "experiments/chapter_3/kit/rate_study.hpp"
#include "experiments/kit/experiment.hpp"

#include <utility>
#include <vector>

namespace placedpar {

using namespace hydraulics;

namespace {

Replay replay_logger_rates(const ReplayContext& context) {
    std::vector<Comparison> comparisons;
    for (const char* noise : {"low", "high"}) {
        const RecordSource simple_plant{"scenario-a", noise, false}, measured_machine{"excavator", noise, true};
        comparisons.push_back(rate_comparison(context, "simple plant", simple_plant, AreasFrom::spool));
        for (AreasFrom from : {AreasFrom::spool, AreasFrom::servo})
            comparisons.push_back(rate_comparison(context, "measured machine", measured_machine, from));
    }
    return replay_of(std::move(comparisons), {});
}

} // namespace

extern const Experiment logger_rates_experiment{
    .name = "logger-rates",
    .about = "verdicts on sound and faulty machines with loggers of 50 Hz to 5 kHz",
    .chapter = "3",
    .number = 8,
    .run = replay_logger_rates,
    .seeds = 200,
};

} // namespace placedpar
