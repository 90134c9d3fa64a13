#pragma once

#include "observe/page/text_table.hpp"
#include "observe/trace/trace_writer.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace placedpar::page {

/// A piece of a run's trace, packed by Stretch::pack().
struct PackedStretch {
    Time begin, end;
    std::size_t entries; ///< slices and messages
    std::string bytes;
};

/// Collects a piece of a run's trace, which a browser unpacks when it shows this piece: the slices (bars of timelines)
/// and messages of an interval. A packed stretch contains its texts, so it can be unpacked without others.
class Stretch {
public:
    explicit Stretch(Time begin) : begin_(begin), end_(begin) {}

    Time begin() const { return begin_; }
    Time end() const { return end_; } ///< latest end of a slice or message
    std::size_t entries() const { return slices_.size() + arrows_.size(); }

    /// REQUIRES, also for messages: the entry begins neither before the stretch nor before the last entry of its track.
    void add(const Slice&);
    void add(const MessageArrow&);

    /// Packs the stretch. Afterwards the stretch is empty and begins at its former end. The bytes are numbers, written
    /// by append_number(). Values of one kind compress best if they follow each other. So each of these values is
    /// written for all slices or messages before the next value. Times are in picoseconds:
    ///
    ///     texts                 length of the texts in bytes; the texts as JSON
    ///     tracks                number of tracks that have slices; for each: its number, its number of slices
    ///     slices, by track      time since the end of the track's preceding slice, or since the stretch's
    ///                           begin; duration; activity, plus 16 if the slice is open; number of its text
    ///     messages, by leaving  number of messages; sender's track; receiver's track; time since the preceding
    ///                           message left, or since the stretch's begin; duration; number of the
    ///                           channel's text
    PackedStretch pack();

private:
    struct KeptSlice {
        std::uint32_t track, note;
        std::uint8_t activity;
        bool open;
        Time begin, end;
    };
    struct KeptPassage {
        std::uint32_t from, to, channel;
        Time left, arrived;
    };
    void append_slices(std::string& bytes);
    void append_tracks(std::string& bytes) const;
    void append_arrows(std::string& bytes);

    Time begin_, end_;
    std::vector<KeptSlice> slices_;
    std::vector<KeptPassage> arrows_;
    TextTable texts_;
};

} // namespace placedpar::page
