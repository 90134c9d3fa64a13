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

/// A fault of the machine: parameters that differ from those of excavator.csv.
struct PlantFault {
    const char* name;
    std::vector<std::pair<const char*, double>> parameters;
};

PlantFault no_fault();
PlantFault doubled_compliance();
/// Returns a leak k_l across the boom's piston from the opening of the valve. Its name states its share of the steady
/// 50 in^3/s.
PlantFault leak_of(const char* name, double leak_in3_per_s_psi);
/// Returns a drift of the servo-valve: its spool moves as if the voltage were higher by `bias_v`.
PlantFault drift_of(double bias_v);

/// The source of records, and their content.
struct RecordSource {
    const char *scenario, *noise;
    bool has_servo;
    double period_s = hydraulics::sampling_period_s; ///< time between readings
};

hydraulics::Record record_of(const PlantFault& fault, const RecordSource& source, std::uint64_t seed);

/// Runs one search with an engineer's improvements over the samples in which the pressure rises. The identification
/// does not know the fault: it assumes the machine of excavator.csv.
identification::SearchRun search_faulty(const hydraulics::Record& record, hydraulics::AreasFrom from,
                                        std::uint64_t seed);
/// Returns the last answer of search_faulty(), in in^3/psi.
double identified(const hydraulics::Record& record, hydraulics::AreasFrom from, std::uint64_t seed);

/// Returns the result of least squares over the rise, in in^3/psi. Throws if there are too few samples.
double least_squares(const hydraulics::Record& record);

/// Plots the compliance estimated by the spool from one record of each machine, sample by sample. A second panel plots
/// the effect of a drift of the servo-valve on the compliance by spool and by voltage, for the first 5 records.
/// REQUIRES: at least 5 seeds.
Plot plot_of_faults(std::span<const PlantFault> faults, const RecordSource& source,
                    std::span<const std::uint64_t> seeds);

} // namespace placedpar
