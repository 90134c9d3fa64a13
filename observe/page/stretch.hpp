#pragma once

#include "observe/page/text_table.hpp"
#include "observe/trace/trace_writer.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace placedpar::page {

/// A stretch of a run, packed: see Stretch::pack().
struct PackedStretch {
    Time begin, end;
    std::size_t entries; ///< slices and messages
    std::string bytes;
};

/// The slices and messages of a stretch of a run. It stands by itself: its texts are its own.
class Stretch {
public:
    explicit Stretch(Time begin) : begin_(begin), end_(begin) {}

    Time begin() const { return begin_; }
    Time end() const { return end_; } ///< of all that is in it
    std::size_t entries() const { return slices_.size() + arrows_.size(); }

    /// REQUIRES, as the other: it begins neither before the stretch nor before the last one of its track.
    void add(const Slice&);
    void add(const MessageArrow&);

    /// Packs what is in it; it begins anew at its end. As numbers (append_number), one column after the other, since
    /// like compresses best beside like:
    ///   how many bytes of JSON, and these: the texts;
    ///   how many tracks have slices, and of each its number and how many;
    ///   of all slices, track by track: since the end of the one before, or the stretch's beginning; how long;
    ///   what it does, and 16 if it is open; the number of its note;
    ///   how many messages; of all, by when they left: from which track; to which; when, since the one before or the
    ///   beginning; how long; the number of its channel.
    /// Times in picoseconds.
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
