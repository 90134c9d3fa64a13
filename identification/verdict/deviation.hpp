#pragma once

#include "identification/verdict/fault_hypothesis.hpp"

namespace placedpar::identification {

/// Says whether the matrix has an inverse: it has one if it is symmetric, finite and positive definite.
bool has_inverse(const PerPairOfHypotheses&);

/// How much of each way is called one unit: what a verdict is asked to find (ours).
struct WayUnits {
    double compliance_in3_per_psi;      ///< 20 % of the link's compliance
    double leak_in3_per_s_psi = 0.0014; ///< a leak of 5 %: of the steady 50 in^3/s at 1750 psi
    double offset_in = 0.005;           ///< by which the spool's reading is too high
    static constexpr double compliance_share = 0.2;

    /// REQUIRES: compliance above 0.
    static WayUnits of(double compliance_in3_per_psi) { return {compliance_share * compliance_in3_per_psi}; }
};

/// What the equations themselves are off by from one movement to the next, in units, however long it is; ours. An
/// offset repeats better: tuned on the machines of seeds 4001 to 5040, so that leaks that begin with a movement are
/// found.
inline constexpr double repeats_within = 0.15, offset_repeats_within = 0.1375;

/// By how much a link is off in each way, in units of WayUnits, by one movement or by several.
struct Deviation {
    PerHypothesis by{};
    PerPairOfHypotheses covariance{};

    double standard_error(FaultHypothesis) const;
    /// The inverse of the covariance, what does not repeat from movement to movement (repeats_within) added to it.
    PerPairOfHypotheses information() const;
    /// What the deviation is if a leak is the same before the movement and during it. Flow alone hardly tells a leak
    /// from an offset; then the rest before the movement does.
    Deviation with_steady_leak() const;
    friend bool operator==(const Deviation&, const Deviation&) = default;
};

} // namespace placedpar::identification
