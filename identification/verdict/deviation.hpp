#pragma once

#include "identification/verdict/fault_hypothesis.hpp"

namespace placedpar::identification {

/// Returns whether the matrix has an inverse: it must be symmetric, finite and positive definite.
bool has_inverse(const PerPairOfHypotheses&);

/// The size of each deviation that counts as one unit: the size that a verdict should detect (our choice).
struct WayUnits {
    double compliance_in3_per_psi;      ///< 20 % of the link's compliance
    double leak_in3_per_s_psi = 0.0014; ///< a leak of 5 % of the steady flow of 50 in^3/s, at 1750 psi
    double offset_in = 0.005;           ///< amount by which the spool's reading is too high
    static constexpr double compliance_share = 0.2;

    /// REQUIRES: the compliance is above 0.
    static WayUnits of(double compliance_in3_per_psi) { return {compliance_share * compliance_in3_per_psi}; }
};

/// The error of the equations varies from movement to movement, however long the movements are. These constants are the
/// standard deviations of this error, in units: `offset_repeats_within` for offsets, `repeats_within` for all other
/// deviations. We chose both values. The value for offsets is tuned on the machines of seeds 4001 to 5040, so that
/// leaks that begin with a movement are found.
inline constexpr double repeats_within = 0.15, offset_repeats_within = 0.1375;

/// The deviations of a link in units of WayUnits, from one movement or several.
struct Deviation {
    PerHypothesis by{};
    PerPairOfHypotheses covariance{};

    double standard_error(FaultHypothesis) const;
    /// Returns the inverse of the covariance plus the variation between movements (`repeats_within`,
    /// `offset_repeats_within`).
    PerPairOfHypotheses information() const;
    /// Returns the deviation under the assumption that the leak is equal before and during the movement. The rest
    /// before the movement then distinguishes a leak from an offset. The flow during the movement hardly does.
    Deviation with_steady_leak() const;
    friend bool operator==(const Deviation&, const Deviation&) = default;
};

} // namespace placedpar::identification
