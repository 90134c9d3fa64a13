#pragma once

#include "runtime/time.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace placedpar::page {

/// Counts how long each track (the timeline of a processor, process or link) runs and how long it is ready, in bins of
/// time. All bins have the same width. The width doubles whenever there would be too many bins, so a run of any length
/// takes the same memory.
class LoadBins {
public:
    enum class State { running, ready };

    /// The first bin begins at `origin`.
    LoadBins(std::size_t most_bins, Time origin);

    /// Adds an interval. REQUIRES: the intervals of one state of one track do not overlap; no interval begins before
    /// the origin.
    void add(std::size_t track, State, Time begin, Time end);
    /// Merges bins until there are at most `most_bins`.
    void merge_to(std::size_t most_bins);

    Time width() const { return width_; }
    /// Returns a character of `level_digits` for each bin: the first character if the track was never in the state
    /// during the bin, the last character if the track was always in the state. Empty bins at the end are left out.
    std::string levels(std::size_t track, State) const;

private:
    using Bins = std::vector<Time>;
    struct Track {
        Bins running, ready;
    };
    void widen();
    void spread(Bins&, Time begin, Time end) const;
    std::size_t bin_of(Time t) const { return static_cast<std::size_t>((t - origin_) / width_); }

    std::size_t most_bins_;
    Time origin_, width_{1000};
    std::vector<Track> tracks_;
};

inline constexpr char level_digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

} // namespace placedpar::page
