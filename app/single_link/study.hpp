#pragma once

#include "app/identification/identification.hpp"
#include "hydraulics/measurement.hpp"

#include <cstdint>
#include <vector>

namespace placedpar {

/// What many searches make of scenario A, each with noise and random numbers of its own.
struct Study {
    std::vector<double> error_percent;      ///< of the last estimate, without sign
    std::vector<double> codes_from_optimum; ///< distance from the best of all codes on the last window
    std::vector<double> si_codes;           ///< that optimum's distance from the one found with everything in SI units

    double median_percent() const;
    double ninetieth_percent() const;
    double within_ten_percent() const; ///< percent of the seeds
};

/// The measured transients of seeds 1, 2, ..., from the first.
struct Transients {
    double true_in3_per_psi;
    FlowConstants flow;
    std::vector<std::vector<CircuitSample>> samples;
};
Transients measure_transients(const MeasurementNoise& noise, const UsableSamples& usable, std::size_t seeds,
                              std::uint64_t first_seed);

Study study(const Transients& transients, const IdentificationWay& way, std::uint64_t first_seed);

} // namespace placedpar
