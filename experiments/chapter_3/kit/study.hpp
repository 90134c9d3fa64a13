#pragma once

#include "hydraulics/plant/measurement.hpp"
#include "identification/identification.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace placedpar {

/// The results of many searches for the boom's compliance in scenario A, each with its own noise and random numbers.
struct SearchStudy {
    std::vector<double> error_percent;      ///< absolute value of the last estimate's relative error
    std::vector<double> codes_from_optimum; ///< difference between the code of the last estimate and the best code for
                                            ///< the last window
    /// Difference between the best codes in two computations, one with psi and one with SI units.
    std::vector<double> si_codes;

    double median_percent() const;
    double ninetieth_percent() const;
    double within_ten_percent() const; ///< percentage of seeds with an error of at most 10 %
};

/// The usable samples of a movement, measured once for each seed.
struct Transients {
    double true_in3_per_psi;
    hydraulics::FlowConstants flow;
    std::vector<std::vector<hydraulics::CircuitSample>> samples;
};
Transients measure_transients(const hydraulics::MeasurementNoise& noise, const hydraulics::UsableSamples& usable,
                              std::span<const std::uint64_t> seeds);

/// Makes one search in each of `transients`, with the random numbers of its seed. REQUIRES: one seed for each of
/// `transients.samples`.
SearchStudy study(const Transients& transients, const identification::IdentificationWay& way,
                  std::span<const std::uint64_t> seeds);

} // namespace placedpar
