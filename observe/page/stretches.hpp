#pragma once

#include "observe/page/both_ends.hpp"
#include "observe/trace/tracks.hpp"

namespace placedpar::page {

/// Limits the slices (bars of timelines) and messages of a run's HTML page.
struct Room {
    /// A browser unpacks a stretch with so many entries in some hundredths of a second.
    std::size_t entries_of_stretch = 40'000;
    /// With at most this number of slices and messages, the page is not compressed.
    std::size_t entries_at_once = 250'000;
    std::size_t bytes_of_each_end = 16'000'000; ///< keeps a page below 64 megabytes
};

/// Collects the slices and messages of a run of any length in stretches, that is, packed pieces of the trace. The open
/// stretch receives new entries; a full stretch is packed immediately.
///
/// An entry that begins before the open stretch goes into a second row of longer stretches, or into a third row if it
/// begins before the second row's open stretch. The stretches of a row do not overlap. So a browser finds all entries
/// at a given time in the few stretches that contain this time.
class Stretches {
public:
    Stretches(const Tracks&, Time from, const Room& = {});

    void add(const Slice&);
    void add(const MessageArrow&);
    /// Packs the open stretches. Call it after the last entry.
    void finish();

    // All functions below require that finish() was called.
    bool are_deflated() const { return deflated_; }
    std::size_t left_out() const; ///< number of slices and messages that were left out
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
    std::size_t entries_ = 0; ///< number of packed entries
    bool deflated_ = false;
};

} // namespace placedpar::page
