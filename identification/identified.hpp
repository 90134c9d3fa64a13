#pragma once

#include "hydraulics/circuit/circuit.hpp"
#include "identification/transient_search.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace placedpar::identification {

/// The compliance of one link, as identified.
struct LinkIdentified {
    hydraulics::Link link;
    double compliance_in3_per_psi; ///< the median of the searches
    double lowest, highest;        ///< 5 and 95 % of the searches
    double standard_error;         ///< of least squares on the last window: what the record's noise leaves uncertain
    std::optional<double> optimum; ///< the best of all codes on the last window; none above 20 bits (exhaustive_bits)
    std::optional<double> codes_from_optimum; ///< the searches' median distance from it
    std::vector<std::string> flags;           ///< sentences; empty: nothing unusual
};

struct Identified {
    hydraulics::Circuit circuit;
    std::vector<LinkIdentified> links;        ///< in the circuit's order
    std::vector<TransientEstimate> estimates; ///< of the first search
    std::uint64_t generations = 0;            ///< of all searches
};

} // namespace placedpar::identification
