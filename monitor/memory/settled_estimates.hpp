#pragma once

#include "identification/on_line/diagnosis.hpp"
#include "monitor/memory/entries.hpp"

#include <vector>

namespace placedpar::monitor {

/// Which estimates of a diagnosis are settled: what to compare with after the next message.
class SettledEstimates {
public:
    explicit SettledEstimates(const identification::Diagnosis& diagnosis);

    /// The estimates that were settled and whose transients have ended since, with their standard errors.
    std::vector<KeptEstimate> ended(const identification::Diagnosis& diagnosis, double at) const;

private:
    struct SettledLink {
        hydraulics::LinkSet set;
        std::size_t link; ///< its place in the set
    };
    std::vector<SettledLink> settled_;
};

} // namespace placedpar::monitor
