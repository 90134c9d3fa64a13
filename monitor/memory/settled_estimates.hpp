#pragma once

#include "identification/on_line/diagnosis.hpp"
#include "monitor/memory/entries.hpp"

#include <map>
#include <vector>

namespace placedpar::monitor {

/// Finds the estimates to add to the history of a machine. Remembers which estimates of compliances are settled, that
/// is, agree over many generations, before the diagnosis takes a message. Afterwards, ended() compares.
class SettledEstimates {
public:
    explicit SettledEstimates(const identification::Diagnosis& diagnosis);

    /// Returns the settled estimates whose transients, the times in which a pressure changes, have ended since
    /// construction.
    std::vector<KeptEstimate> ended(const identification::Diagnosis& diagnosis, double at) const;

private:
    struct SettledLink {
        bool recognised; ///< whether the estimate was found in a recognised configuration
        hydraulics::LinkSet set;
        std::size_t link; ///< index of the link in the set

        friend auto operator<=>(const SettledLink&, const SettledLink&) = default;
    };
    struct Before {
        bool settled;
        double time_s; ///< time of the newest settled value
    };
    bool has_ended(const SettledLink&, const identification::LinkEstimate::State& now) const;

    std::map<SettledLink, Before> before_;
};

} // namespace placedpar::monitor
