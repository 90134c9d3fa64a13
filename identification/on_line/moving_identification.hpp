#pragma once

#include "hydraulics/circuit/link_calibration.hpp"
#include "hydraulics/data/record.hpp"
#include "identification/on_line/moving_search.hpp"

#include <array>
#include <optional>

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

/// Identifies the compliances of a machine that moves from its record (moving_search.hpp).
class MovingIdentification {
public:
    MovingIdentification(const hydraulics::Parameters& machine, MovingSearch::WayFor way, std::uint64_t seed);

    /// Takes the next piece of a record. REQUIRES: recognisable(piece.channels()).
    void take(const hydraulics::Record& piece);
    /// Returns the answers of all sets with enough samples, in the order of Figure 3.13.
    std::vector<SetAnswer> sets() { return search_ ? search_->answers() : std::vector<SetAnswer>(); }
    const Recognition& recognition() const { return recognition_; }
    double healthy_in3_per_psi(hydraulics::Link link) const { return machine_.healthy_in3_per_psi[index_of(link)]; }

private:
    void take(const hydraulics::Record& piece, std::size_t i);
    void judge(char truth);

    RecognisedMachine machine_;
    hydraulics::PerLink<hydraulics::LinkConstants> constants_;
    MovingSearch::WayFor way_;
    std::uint64_t seed_;
    std::optional<MovingSearch> search_; ///< empty before the first reading
    double period_s_ = 0, time_s_ = 0;
    std::size_t readings_ = 0;
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
