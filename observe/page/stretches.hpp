#pragma once

#include "observe/page/both_ends.hpp"
#include "observe/trace/tracks.hpp"

namespace placedpar::page {

/// How much there is room for.
struct Room {
    std::size_t entries_of_stretch = 40'000;    ///< a stretch is unpacked in some hundredths of a second
    std::size_t entries_at_once = 250'000;      ///< a run of no more is not compressed
    std::size_t bytes_of_each_end = 16'000'000; ///< a page stays below 64 megabytes
};

/// The slices and messages of a run of any length, in stretches, each packed as soon as it is full.
///
/// One that begins before the present stretch does, since it took longer, lies in one of another row of stretches,
/// which are longer, as there are fewer such; or if it begins before the present one of these, in one of a third row.
/// Those of a row do not overlap. So whoever knows all stretches that a moment lies in knows all that there was at that
/// moment.
class Stretches {
public:
    Stretches(const Tracks&, Time from, const Room& = {});

    void add(const Slice&);
    void add(const MessageArrow&);
    /// Nothing more comes.
    void finish();

    // REQUIRES, all: it is finished.
    bool are_deflated() const { return deflated_; }
    std::size_t left_out() const; ///< slices and messages
    std::optional<Period> lost() const;
    std::vector<const PackedStretch*> all() const;

private:
    struct Row {
        Stretch open;
        BothEnds kept;
    };
    Row& row_for(Time begin);
    void pack_if_full(Row&);
    void pack(Row&);

    const Tracks& tracks_;
    Time from_;
    Room room_;
    std::deque<Row> rows_;
    std::size_t entries_ = 0; ///< that are packed
    bool deflated_ = false;
};

} // namespace placedpar::page
