#pragma once

#include "gaprocs/settings.hpp"
#include "identification/excitation_gate.hpp"

#include <cstddef>

namespace placedpar::identification {

/// The number of transients whose settled compliances are kept for each link. A transient is a time in which the
/// pressure changes. A compliance is settled when many generations agree.
inline constexpr std::size_t kept_transients = 5;

/// Returns the search settings of the thesis, with one elite individual in addition.
SearchSettings service_search();

/// The settings of the on-line diagnosis. The diagnosis searches as the thesis does, with four differences: one elite
/// individual, Gray code, the signed flow into the cylinder, and a gate. The gate stops the search while the pressure
/// changes too slowly to determine the compliance.
struct DiagnosisSettings {
    SearchSettings search = service_search(); ///< window 10, bias 400, 5 trials, population 120, 1 elite
    std::size_t bits = 10;                    ///< bits per compliance; not printed in the thesis
    ExcitationGate gate;                      ///< while it is shut, the estimate of the compliance is frozen
    /// The number of usable samples to leave out after the path to a cylinder has opened; our choice.
    std::size_t skipped = 2;
    /// The estimate is the median of the best individuals of this many generations; our choice.
    std::size_t median_over = 25;
    /// An estimate is settled if (greatest - least) / median of these individuals is at most this number; our choice.
    double settled_within = 0.2;
    double inconsistent_over = 0.3; ///< greatest (greatest - least) / median of the compliances that several sets of
                                    ///< links found for one link; our choice
    double stale_after_s = 600;     ///< estimates older than this are left out of cross-checks; our choice

    /// Returns the difference between the compliances of neighbouring codes.
    double step_in3_per_psi() const;
    /// If a setting is out of range, throws a UserError that names the setting and its valid range.
    void validate() const;
};

} // namespace placedpar::identification
