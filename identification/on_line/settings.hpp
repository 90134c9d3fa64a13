#pragma once

#include "gaprocs/settings.hpp"
#include "identification/excitation_gate.hpp"

#include <cstddef>

namespace placedpar::identification {

/// Transients of a link whose settled values are kept.
inline constexpr std::size_t kept_transients = 5;

/// The thesis's numbers, with one elite individual.
SearchSettings service_search();

/// How the on-line diagnosis searches. The search is the thesis's with what an engineer would
/// add: one elite individual, Gray code, signed flow into the cylinder, a gate on excitation.
struct DiagnosisSettings {
    SearchSettings search = service_search(); ///< window 10, bias 400, 5 trials, population 120, 1 elite
    std::size_t bits = 10;                    ///< of one compliance; the thesis does not print it
    ExcitationGate gate;                      ///< below which an estimate is frozen
    std::size_t skipped = 2;                  ///< usable samples left out after the path to a cylinder opened; ours
    std::size_t median_over = 25;             ///< generations whose best individuals' median is the estimate; ours
    double settled_within = 0.2;    ///< (greatest - least) / median of those, at which it counts as settled; ours
    double inconsistent_over = 0.3; ///< (greatest - least) / median between population sets; ours
    double stale_after_s = 600;     ///< estimates older than this take no part in cross-checks; ours

    /// The resolution of a compliance.
    double step_in3_per_psi() const;
    /// Throws UserError, saying which setting is out of range and what would be right.
    void validate() const;
};

} // namespace placedpar::identification
