#pragma once

#include "identification/verdict/fault_hypothesis.hpp"

namespace placedpar::identification {

/// Returns whether the matrix has an inverse: it must be symmetric, finite and positive definite.
bool has_inverse(const PerPairOfHypotheses&);

/// The size of each kind of deviation that counts as one unit. A verdict should detect a deviation of one unit. The
/// sizes are this project's choice.
struct WayUnits {
    double compliance_in3_per_psi;      ///< 20 % of the link's compliance
    double leak_in3_per_s_psi = 0.0014; ///< a leak of 5 % of the steady flow of 50 in^3/s, at 1750 psi
    double offset_in = 0.005;           ///< amount by which the spool's reading is too high
    static constexpr double compliance_share = 0.2;

    /// REQUIRES: the compliance is above 0.
    static WayUnits of(double compliance_in3_per_psi) { return {compliance_share * compliance_in3_per_psi}; }
};

/// The equations are not exact. Therefore the deviations found in the movements of an unchanged link scatter, however
/// long the movements are. These constants are the standard deviations of this scatter, in the units of WayUnits:
/// `offset_repeats_within` for offsets, `repeats_within` for all other deviations. Both values are this project's
/// choice. The value for offsets is tuned on simulated machines, so that leaks that begin with a movement are found.
inline constexpr double repeats_within = 0.15, offset_repeats_within = 0.1375;

/// How far a link deviates from a healthy link, in units of WayUnits, as found from one movement or several.
struct Deviation {
    PerHypothesis by{};
    PerPairOfHypotheses covariance{};

    double standard_error(FaultHypothesis) const;
    /// Adds the variation between movements (`repeats_within`, `offset_repeats_within`) to the covariance, and returns
    /// the inverse of the sum, the weight of this deviation in a mean.
    PerPairOfHypotheses information() const;
    /// Returns the deviation under the assumption that the leak is equal before and during the movement. Readings at
    /// rest before the movement then distinguish a leak from an offset. Readings during the movement hardly do.
    Deviation with_steady_leak() const;
    friend bool operator==(const Deviation&, const Deviation&) = default;
};

} // namespace placedpar::identification
