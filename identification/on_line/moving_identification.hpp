#pragma once

#include "hydraulics/circuit/link_calibration.hpp"
#include "hydraulics/data/record.hpp"
#include "identification/on_line/moving_search.hpp"

#include <array>
#include <optional>

namespace placedpar::identification {

/// Returns whether the main valve's configurations can be recognised from a record: all links must have inlet pressure,
/// angle and orifice areas.
bool recognisable(const hydraulics::ChannelSet& there);

/// Counts how often the recognised configuration was right, if the record has a column of true configurations.
struct Recognition {
    std::array<std::size_t, hydraulics::all_configurations.size()>
        samples{}; ///< number of samples of each recognised configuration
    std::size_t judged = 0, right = 0;
    /// The numbers of changes of configuration, and of those that were recognised within two samples.
    std::size_t changes = 0, soon = 0;
};

/// Identifies compliances from the record of a working machine whose configurations change. Recognises the
/// configurations from the readings (moving_search.hpp).
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
    std::size_t awaited_until_ = 0; ///< a change that is recognised up to this reading counts in Recognition::soon
};

/// Returns the compliance of each link: the mean of the answers of all sets that contain the link, weighted by their
/// errors. Flags a link if its sets disagree (cross-check 1 of thesis 3.3) or if the mean is uncertain. Leaves out
/// links without an answer.
std::vector<LinkIdentified> combined_links(const std::vector<SetAnswer>& sets);

/// Returns a text that says where the faults are, one line for each fault (cross-check 2 of thesis 3.3). If one link's
/// compliance is wrong in all sets, the fault is in this link. If both links that one pump feeds have wrong
/// compliances, the fault is in a part that they share.
std::string locate_faults(const std::vector<LinkIdentified>& links, const hydraulics::PerLink<double>& healthy);

} // namespace placedpar::identification
