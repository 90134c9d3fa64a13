#pragma once

#include "observe/page/stretch.hpp"

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

namespace placedpar::page {

/// From when to when.
struct Period {
    Time begin, end;
};

/// The first and the last of many stretches: all of them while there is room.
class BothEnds {
public:
    explicit BothEnds(std::size_t bytes_of_each_end) : most_(bytes_of_each_end) {}

    /// REQUIRES: it begins no earlier than the one before.
    void add(PackedStretch);
    /// Compresses those that are here.
    void deflate();

    std::size_t left_out() const { return left_out_; }   ///< slices and messages
    std::optional<Period> lost() const { return lost_; } ///< where any are left out
    /// In the order in which they came.
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
