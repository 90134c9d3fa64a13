#pragma once

#include "hydraulics/data/link.hpp"

#include <cstddef>
#include <vector>

namespace placedpar::identification {

/// The settled compliance that one population set found for a link. A population set is a set of links whose
/// compliances one population searches together. An estimate is settled when the best individuals of many generations
/// agree.
struct SetEstimate {
    hydraulics::LinkSet set;
    double compliance_in3_per_psi; ///< the newest settled value
    double lasting_in3_per_psi;    ///< median of the settled values of the last transients, the times in which the
                                   ///< pressure changes
    std::size_t transients;        ///< number of settled transients; at most kept_transients
    double time_s;                 ///< time of the newest settled value
};

/// Cross-check 1 of thesis 3.3 compares the compliances that several population sets found for one link in different
/// configurations of the main valve. If they disagree, none of them can be trusted.
struct LinkCheck {
    std::vector<SetEstimate> estimates; ///< estimates of the last minutes, ordered by the name of the set

    /// Returns (greatest - least) / median of the estimates, or 0 for fewer than two estimates.
    double spread() const;
};

} // namespace placedpar::identification
