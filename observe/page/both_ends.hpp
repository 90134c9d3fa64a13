#pragma once

#include "observe/page/stretch.hpp"

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

namespace placedpar::page {

/// An interval of simulated time.
struct Period {
    Time begin, end;
};

/// Keeps the beginning and the end of a trace in limited memory. The trace comes in stretches, that is, packed pieces.
/// BothEnds keeps the first and the last stretches, up to a number of bytes each, and drops the stretches in between.
class BothEnds {
public:
    explicit BothEnds(std::size_t bytes_of_each_end) : most_(bytes_of_each_end) {}

    /// REQUIRES: the stretch begins no earlier than the stretch before it.
    void add(PackedStretch);
    /// Compresses the stretches.
    void deflate();

    std::size_t left_out() const {
        return left_out_;
    } ///< number of slices (bars of timelines) and messages in dropped stretches
    std::optional<Period> lost() const { return lost_; } ///< interval of the dropped stretches, if any
    /// Returns the stretches in the order in which they were added.
    std::vector<const PackedStretch*> all() const;

private:
    struct End {
        std::deque<PackedStretch> stretches;
        std::size_t bytes = 0;
        void add(PackedStretch);
        PackedStretch take_first();
    };

    std::size_t most_, left_out_ = 0;
    End first_, last_;
    std::optional<Period> lost_;
};

} // namespace placedpar::page
