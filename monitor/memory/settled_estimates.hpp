#pragma once

#include "identification/on_line/diagnosis.hpp"
#include "monitor/memory/entries.hpp"

#include <vector>

namespace placedpar::monitor {

/// Remembers which estimates of a diagnosis are settled, for comparison after the next message.
class SettledEstimates {
public:
    explicit SettledEstimates(const identification::Diagnosis& diagnosis);

    /// Returns the estimates that were settled at construction and whose transients have ended since, with standard
    /// errors.
    std::vector<KeptEstimate> ended(const identification::Diagnosis& diagnosis, double at) const;

private:
    struct SettledLink {
        hydraulics::LinkSet set;
        std::size_t link; ///< index of the link in the set
    };
    std::vector<SettledLink> settled_;
};

} // namespace placedpar::monitor
