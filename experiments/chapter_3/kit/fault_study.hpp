#pragma once

#include "hydraulics/data/record.hpp"
#include "hydraulics/plant/measurement.hpp"
#include "hydraulics/plant/record_scenario.hpp"
#include "identification/identification.hpp"
#include "picture/plot.hpp"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace placedpar {

/// A fault of the machine, as values that replace parameters of `excavator.csv`.
struct PlantFault {
    const char* name;
    std::vector<std::pair<const char*, double>> parameters;
};

PlantFault no_fault();
PlantFault doubled_compliance();
/// Returns a leak with the coefficient k_l across the boom's piston. The leak begins when the valve of scenario A
/// opens. `name` should state the leak's flow as a share of the steady flow of 50 in^3/s.
PlantFault leak_of(const char* name, double leak_in3_per_s_psi);
/// Returns a drift of the servo-valve. The spool moves as if the voltage were higher by `bias_v`.
PlantFault drift_of(double bias_v);

/// What determines the records of a simulated excavator: the names of the scenario (machine and motion) and of the
/// noise level, and whether there is a servo-valve.
struct RecordSource {
    const char *scenario, *noise;
    bool has_servo;
    double period_s = hydraulics::sampling_period_s; ///< time between readings
};

hydraulics::Record record_of(const PlantFault& fault, const RecordSource& source, std::uint64_t seed);

/// Runs one search for the compliance, with Gray code and one elite individual. The search uses the samples in which
/// the pressure rises, except the first two. It does not know the fault, but assumes the parameters of `excavator.csv`.
identification::SearchRun search_faulty(const hydraulics::Record& record, hydraulics::AreasFrom from,
                                        std::uint64_t seed);
/// Returns the last answer of search_faulty(), in in^3/psi.
double identified(const hydraulics::Record& record, hydraulics::AreasFrom from, std::uint64_t seed);

/// Returns the compliance in in^3/psi that least squares finds from the samples in which the pressure rises. Throws if
/// there are too few such samples.
double least_squares(const hydraulics::Record& record);

/// Plots the compliance over time, estimated from the spool in one record for each fault. A second panel plots the last
/// estimates from the spool and from the voltage over the drift of the servo-valve, as medians of 5 records. REQUIRES:
/// at least 5 seeds.
Plot plot_of_faults(std::span<const PlantFault> faults, const RecordSource& source,
                    std::span<const std::uint64_t> seeds);

} // namespace placedpar
