#pragma once

#include "hydraulics/plant/measurement.hpp"
#include "identification/identification.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace placedpar {

/// What many searches make of scenario A, each with noise and random numbers of its own.
struct SearchStudy {
    std::vector<double> error_percent;      ///< of the last estimate, without sign
    std::vector<double> codes_from_optimum; ///< distance from the best of all codes on the last window
    std::vector<double> si_codes;           ///< that optimum's distance from the one found with everything in SI units

    double median_percent() const;
    double ninetieth_percent() const;
    double within_ten_percent() const; ///< percent of the seeds
};

/// Measured transients, one a seed.
struct Transients {
    double true_in3_per_psi;
    hydraulics::FlowConstants flow;
    std::vector<std::vector<hydraulics::CircuitSample>> samples;
};
Transients measure_transients(const hydraulics::MeasurementNoise& noise, const hydraulics::UsableSamples& usable,
                              std::span<const std::uint64_t> seeds);

/// REQUIRES: a seed for each transient.
SearchStudy study(const Transients& transients, const identification::IdentificationWay& way,
                  std::span<const std::uint64_t> seeds);

} // namespace placedpar
