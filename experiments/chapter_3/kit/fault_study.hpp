#pragma once

#include "hydraulics/data/record.hpp"
#include "hydraulics/plant/record_scenario.hpp"
#include "identification/identification.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace placedpar {

/// What is wrong with the machine: parameters that differ from those of excavator.csv.
struct Fault {
    const char* name;
    std::vector<std::pair<const char*, double>> parameters;
};

Fault no_fault();
Fault doubled_compliance();
/// A leak k_l across the boom's piston from valve opening; its name gives its share of the steady 50 in^3/s.
Fault leak_of(const char* name, double leak_in3_per_s_psi);
/// The servo-valve's spool goes where another voltage would send it.
Fault drift_of(double bias_v);

/// Where the records come from, and what they hold.
struct Plant {
    const char *scenario, *noise;
    bool has_servo;
};

hydraulics::Record record_of(const Fault& fault, const Plant& plant, std::uint64_t seed);

/// One search, the engineer's way, while the pressure rises. The identifier knows nothing of the fault: it takes the
/// machine to be that of excavator.csv.
identification::SearchRun search_faulty(const hydraulics::Record& record, hydraulics::AreasFrom from,
                                        std::uint64_t seed);
/// Its last answer, in in^3/psi.
double identified(const hydraulics::Record& record, hydraulics::AreasFrom from, std::uint64_t seed);

/// By least squares over the rise, in in^3/psi. Throws where there is nothing to fit.
double least_squares(const hydraulics::Record& record);

} // namespace placedpar
