#include "experiments/chapter_3/kit/fault_study.hpp"

#include "text/statistics.hpp"

namespace placedpar {

using namespace hydraulics;
using namespace identification;

namespace {

constexpr std::size_t records_a_drift = 5;
constexpr int farthest_mv = 30, drift_step_mv = 5;
const Axis compliance_axis{"compliance [0.001 in³/psi]", 0, 20};

GuideLine true_mark() { return {"true, sound", 1000 * Parameters::excavator()["boom.inlet_compliance"]}; }

Panel panel_over_samples(std::span<const PlantFault> faults, const RecordSource& source, std::uint64_t seed) {
    Panel panel{"a: C_BOi estimated from the spool, after each sample of one record",
                {"time [s]", 0.3, 0.6}, // from the first estimate to the end of the slowest rise of the pressure
                compliance_axis,
                {},
                {true_mark()}};
    for (const PlantFault& fault : faults) {
        Series series{fault.name, {}};
        for (const TransientEstimate& estimate :
             search_faulty(record_of(fault, source, seed), AreasFrom::spool, seed).estimates)
            series.points.push_back({estimate.time_s, 1000 * estimate.compliance_in3_per_psi[0]});
        panel.series.push_back(std::move(series));
    }
    return panel;
}

Panel panel_over_drift(const RecordSource& source, std::span<const std::uint64_t> seeds) {
    Panel panel{"b: a drift of the servo-valve, last estimate, median of 5 records",
                {"drift [mV]", -farthest_mv, farthest_mv},
                compliance_axis,
                {{"by the spool", {}}, {"by the voltage", {}}},
                {true_mark()}};
    for (int drift_mv = -farthest_mv; drift_mv <= farthest_mv; drift_mv += drift_step_mv) {
        std::vector<double> by_spool, by_voltage;
        for (std::uint64_t seed : seeds.first(records_a_drift)) {
            Record record = record_of(drift_of(0.001 * drift_mv), source, seed);
            by_spool.push_back(identified(record, AreasFrom::spool, seed));
            by_voltage.push_back(identified(record, AreasFrom::servo, seed));
        }
        panel.series[0].points.push_back({1.0 * drift_mv, 1000 * lower_median(by_spool)});
        panel.series[1].points.push_back({1.0 * drift_mv, 1000 * lower_median(by_voltage)});
    }
    return panel;
}

} // namespace

Plot plot_of_faults(std::span<const PlantFault> faults, const RecordSource& source,
                    std::span<const std::uint64_t> seeds) {
    return {"The effect of faults of the machine on the compliance that is found",
            {panel_over_samples(faults, source, seeds.front()), panel_over_drift(source, seeds)}};
}

} // namespace placedpar
