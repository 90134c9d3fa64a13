#pragma once

#include "hydraulics/data/link.hpp"

#include <cstddef>
#include <vector>

namespace placedpar::identification {

/// The settled compliance that one population set found for a link.
struct SetEstimate {
    hydraulics::LinkSet set;
    double compliance_in3_per_psi; ///< the newest settled value
    double lasting_in3_per_psi;    ///< median of the settled values of the last transients
    std::size_t transients;        ///< number of settled transients; at most kept_transients
    double time_s;                 ///< time of the newest settled value
};

/// Cross-check 1 of thesis 3.3 compares the compliances that several population sets found for one link under different
/// hydraulic configurations.
struct LinkCheck {
    std::vector<SetEstimate> estimates; ///< estimates that are not stale, ordered by name of set

    /// Returns (greatest - least) / median, or 0 for fewer than two estimates.
    double spread() const;
};

} // namespace placedpar::identification
