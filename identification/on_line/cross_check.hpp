#pragma once

#include "hydraulics/data/link.hpp"

#include <cstddef>
#include <vector>

namespace placedpar::identification {

/// The compliance of a link as one population set has found it, once settled.
struct SetEstimate {
    hydraulics::LinkSet set;
    double compliance_in3_per_psi; ///< the newest settled value
    double lasting_in3_per_psi;    ///< median over the last transients
    std::size_t transients;        ///< that settled; at most kept_transients
    double time_s;                 ///< of the newest
};

/// Cross-check 1 of thesis 3.3: the same compliance, found by several population sets under different hydraulic
/// configurations.
struct LinkCheck {
    std::vector<SetEstimate> estimates; ///< ordered by name of set, none of them stale

    /// (greatest - least) / median; 0 with fewer than two estimates.
    double spread() const;
};

} // namespace placedpar::identification
