#pragma once

#include "identification/on_line/diagnosis.hpp"
#include "monitor/memory/entries.hpp"

#include <vector>

namespace placedpar::monitor {

/// Which estimates of a diagnosis are settled: what to compare with after the next message.
class Settled {
public:
    explicit Settled(const identification::Diagnosis& diagnosis);

    /// The estimates that were settled and whose transients have ended since, with their standard errors.
    std::vector<KeptEstimate> ended(const identification::Diagnosis& diagnosis, double at) const;

private:
    struct Place {
        hydraulics::LinkSet set;
        std::size_t link; ///< its place in the set
    };
    std::vector<Place> settled_;
};

} // namespace placedpar::monitor
