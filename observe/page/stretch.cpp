#include "observe/page/stretch.hpp"

#include "observe/page/encoding.hpp"
#include "text/utf8.hpp"

#include <boost/json.hpp>

#include <algorithm>
#include <utility>

namespace placedpar::page {

namespace {

/// Returns the text of a slice. The text of a wait has a line for each channel, with the partner after a tab, and a
/// line for its timer. The text of any other slice is its subject.
std::string note_of(const Slice& slice) {
    std::string note = slice.subject;
    for (const Awaited& each : slice.awaited)
        note += (note.empty() ? "" : "\n") + each.channel + "\t" + each.partner;
    if (slice.awaits_timer)
        note += note.empty() ? "its timer" : "\nits timer";
    return note;
}

template <class Entry, class Number>
void append_column(std::string& bytes, const std::vector<Entry>& entries, Number number_of) {
    for (const Entry& each : entries)
        append_number(bytes, static_cast<std::uint64_t>(number_of(each)));
}

} // namespace

void Stretch::add(const Slice& slice) {
    end_ = std::max(end_, slice.end);
    slices_.push_back({static_cast<std::uint32_t>(slice.track), texts_.number_of(note_of(slice)),
                       static_cast<std::uint8_t>(slice.activity), slice.open, slice.begin, slice.end});
}

void Stretch::add(const MessageArrow& arrow) {
    end_ = std::max(end_, arrow.arrived);
    arrows_.push_back({static_cast<std::uint32_t>(arrow.from), static_cast<std::uint32_t>(arrow.to),
                       texts_.number_of(arrow.channel), arrow.left, arrow.arrived});
}

/// The vectors are cleared and not replaced, so that the next stretch uses their memory again.
PackedStretch Stretch::pack() {
    std::string texts = as_json(boost::json::serialize(texts_.json())), bytes;
    append_number(bytes, texts.size());
    bytes += texts;
    append_slices(bytes);
    append_arrows(bytes);
    PackedStretch packed{begin_, end_, entries(), std::move(bytes)};
    begin_ = end_;
    slices_.clear();
    arrows_.clear();
    texts_ = {};
    return packed;
}

void Stretch::append_slices(std::string& bytes) {
    std::ranges::stable_sort(slices_, {}, &KeptSlice::track);
    append_tracks(bytes);
    append_column(bytes, slices_,
                  [this, before = static_cast<const KeptSlice*>(nullptr)](const KeptSlice& each) mutable {
                      const KeptSlice* last = std::exchange(before, &each);
                      return (each.begin - (last && last->track == each.track ? last->end : begin_)).count();
                  });
    append_column(bytes, slices_, [](const KeptSlice& each) { return (each.end - each.begin).count(); });
    append_column(bytes, slices_, [](const KeptSlice& each) { return each.activity + (each.open ? 16 : 0); });
    append_column(bytes, slices_, [](const KeptSlice& each) { return each.note; });
}

/// Appends the number of tracks and, for each track, its number and its number of slices. REQUIRES: slices_ is sorted
/// by track.
void Stretch::append_tracks(std::string& bytes) const {
    std::uint64_t tracks = 0;
    std::string each_track;
    for (auto slice = slices_.begin(); slice != slices_.end(); ++tracks) {
        auto behind = std::ranges::upper_bound(slice, slices_.end(), slice->track, {}, &KeptSlice::track);
        append_number(each_track, slice->track);
        append_number(each_track, static_cast<std::uint64_t>(behind - slice));
        slice = behind;
    }
    append_number(bytes, tracks);
    bytes += each_track;
}

void Stretch::append_arrows(std::string& bytes) {
    std::ranges::stable_sort(arrows_, {}, &KeptPassage::left);
    append_number(bytes, arrows_.size());
    append_column(bytes, arrows_, [](const KeptPassage& each) { return each.from; });
    append_column(bytes, arrows_, [](const KeptPassage& each) { return each.to; });
    append_column(bytes, arrows_, [before = begin_](const KeptPassage& each) mutable {
        return (each.left - std::exchange(before, each.left)).count();
    });
    append_column(bytes, arrows_, [](const KeptPassage& each) { return (each.arrived - each.left).count(); });
    append_column(bytes, arrows_, [](const KeptPassage& each) { return each.channel; });
}

} // namespace placedpar::page
