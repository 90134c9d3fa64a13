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

/// What is wrong with the machine: parameters that differ from those of excavator.csv.
struct PlantFault {
    const char* name;
    std::vector<std::pair<const char*, double>> parameters;
};

PlantFault no_fault();
PlantFault doubled_compliance();
/// A leak k_l across the boom's piston from valve opening; its name gives its share of the steady 50 in^3/s.
PlantFault leak_of(const char* name, double leak_in3_per_s_psi);
/// The servo-valve's spool goes where another voltage would send it.
PlantFault drift_of(double bias_v);

/// Where the records come from, and what they hold.
struct RecordSource {
    const char *scenario, *noise;
    bool has_servo;
    double period_s = hydraulics::sampling_period_s; ///< between readings
};

hydraulics::Record record_of(const PlantFault& fault, const RecordSource& source, std::uint64_t seed);

/// One search, the engineer's way, while the pressure rises. The identifier knows nothing of the fault: it takes the
/// machine to be that of excavator.csv.
identification::SearchRun search_faulty(const hydraulics::Record& record, hydraulics::AreasFrom from,
                                        std::uint64_t seed);
/// Its last answer, in in^3/psi.
double identified(const hydraulics::Record& record, hydraulics::AreasFrom from, std::uint64_t seed);

/// By least squares over the rise, in in^3/psi. Throws where there is nothing to fit.
double least_squares(const hydraulics::Record& record);

/// The compliance estimated from one record of each machine by the spool, sample by sample; and what a drift of the
/// servo-valve makes of the compliance by the spool and by the voltage, of the first 5 records. REQUIRES: so many
/// seeds.
Plot plot_of_faults(std::span<const PlantFault> faults, const RecordSource& source,
                    std::span<const std::uint64_t> seeds);

} // namespace placedpar
