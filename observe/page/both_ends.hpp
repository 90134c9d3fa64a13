#pragma once

#include "observe/page/stretch.hpp"

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

namespace placedpar::page {

/// An interval of virtual time.
struct Period {
    Time begin, end;
};

/// Keeps the first and the last stretches, up to a number of bytes at each end. Drops the stretches in between.
class BothEnds {
public:
    explicit BothEnds(std::size_t bytes_of_each_end) : most_(bytes_of_each_end) {}

    /// REQUIRES: the stretch begins no earlier than the stretch before it.
    void add(PackedStretch);
    /// Compresses the stretches that are held.
    void deflate();

    std::size_t left_out() const { return left_out_; }   ///< number of slices and messages that were left out
    std::optional<Period> lost() const { return lost_; } ///< interval of the stretches that were left out, if any
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
