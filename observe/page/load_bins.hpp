#pragma once

#include "runtime/time.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace placedpar::page {

/// What share of its time each track runs, or is ready to, bin by bin: bins of one width, which doubles whenever there
/// would be too many of them. So a run of any length takes the same room.
class LoadBins {
public:
    enum class State { running, ready };

    /// The first bin begins at the origin.
    LoadBins(std::size_t most_bins, Time origin);

    /// REQUIRES: what is added to one state of one track does not overlap; none of it lies before the origin.
    void add(std::size_t track, State, Time begin, Time end);
    /// Makes them at most so many.
    void merge_to(std::size_t most_bins);

    Time width() const { return width_; }
    /// A character a bin, in the order of the 64 of level_digits: none of it, ..., all of it. Bins at the end in which
    /// there is nothing are left out.
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
