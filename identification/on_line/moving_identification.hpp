#pragma once

#include "hydraulics/circuit/configuration_watch.hpp"
#include "hydraulics/circuit/link_calibration.hpp"
#include "identification/on_line/set_search.hpp"

#include <array>
#include <functional>

namespace placedpar::identification {

/// Returns whether configurations can be recognised from a record: all links have inlet pressure, angle and areas.
bool recognisable(const hydraulics::ChannelSet& there);

/// Counts how often the recognised configuration agreed with the column of configurations in the record.
struct Recognition {
    std::array<std::size_t, hydraulics::all_configurations.size()>
        samples{}; ///< number of samples of each recognised configuration
    std::size_t judged = 0, right = 0;
    std::size_t changes = 0, soon = 0; ///< changes of configuration, and the changes that were recognised within two
                                       ///< samples
};

/// Identifies the compliances of a machine that moves (thesis 3.3). Recognises the configuration of each sample and the
/// links into which oil flows, and searches with the population set of these links (Figure 3.13). Whenever the
/// configuration or the links change, the search of each set that was in use until then makes a round
/// of generations (SetSearch::round()).
class MovingIdentification {
public:
    /// Returns the settings of a search for this number of links.
    using WayFor = std::function<WholeWay(std::size_t links)>;

    MovingIdentification(const hydraulics::Parameters& machine, WayFor way, std::uint64_t seed);

    /// Takes the next piece of a record. REQUIRES: recognisable(piece.channels()).
    void take(const hydraulics::Record& piece);
    /// Returns the answers of all sets with enough samples, in the order of Figure 3.13.
    std::vector<SetAnswer> sets();
    const Recognition& recognition() const { return recognition_; }
    double healthy_in3_per_psi(hydraulics::Link link) const { return healthy_in3_per_psi_[index_of(link)]; }

private:
    struct Pending {
        std::size_t at;
        hydraulics::LinkSet set;
        hydraulics::CircuitSample sample;
    };

    void take(const hydraulics::Record& piece, std::size_t i);
    void collect(double time_s);
    void judge(char truth);
    SetSearch& search_of(hydraulics::LinkSet set);

    hydraulics::MainValve valve_;
    hydraulics::CrossOverLimits limits_;
    hydraulics::PerLink<hydraulics::LinkConstants> constants_;
    hydraulics::PerLink<double> healthy_in3_per_psi_{};
    WayFor way_;
    std::uint64_t seed_;
    std::optional<hydraulics::ConfigurationWatch> watch_; ///< empty before the first reading
    double period_s_ = 0, time_s_ = 0;
    std::size_t readings_ = 0;
    hydraulics::Configuration before_{};
    std::vector<hydraulics::LinkSet> in_use_;
    std::vector<Pending> pending_; ///< samples that wait, because their last readings may still prove to be of a
                                   ///< different configuration
    std::map<hydraulics::LinkSet, std::size_t> next_; ///< for each set, the first reading that its next sample may use,
                                                      ///< so that samples do not overlap
    std::map<hydraulics::LinkSet, SetSearch> searches_;
    Recognition recognition_;
    char truth_ = '-';              ///< configuration of the last sample, as stated in the record's column
    std::size_t awaited_until_ = 0; ///< if the change is recognised by this reading, it counts in Recognition::soon
};

/// Returns the answer for each link: the mean over its sets, weighted by their errors. A link is flagged if its sets
/// disagree (cross-check 1 of thesis 3.3) or if the mean is uncertain. Links without an answer of any set are left out.
std::vector<LinkIdentified> combined_links(const std::vector<SetAnswer>& sets);

/// Returns the text of cross-check 2 (thesis 3.3), one line for each fault. A fault is in a link whose compliance is
/// wrong in all sets, or in a part that both links of a branch share.
std::string locate_faults(const std::vector<LinkIdentified>& links, const hydraulics::PerLink<double>& healthy);

} // namespace placedpar::identification
