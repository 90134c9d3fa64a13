#include "workbench/page/stretch.hpp"

#include "workbench/page/encoding.hpp"

#include <algorithm>
#include <utility>

namespace placedpar::page {

namespace {

/// The subject of what runs; of a wait a line for each channel, with the partner behind a tabulator.
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
                       static_cast<std::uint8_t>(slice.doing), slice.open, slice.begin, slice.end});
}

void Stretch::add(const Passage& passage) {
    end_ = std::max(end_, passage.arrived);
    passages_.push_back({static_cast<std::uint32_t>(passage.from), static_cast<std::uint32_t>(passage.to),
                         texts_.number_of(passage.channel), passage.left, passage.arrived});
}

PackedStretch Stretch::packed() const {
    std::string texts = boost::json::serialize(texts_.json()), bytes;
    append_number(bytes, texts.size());
    bytes += texts;
    append_slices(bytes);
    append_passages(bytes);
    return {begin_, end_, entries(), std::move(bytes)};
}

void Stretch::append_slices(std::string& bytes) const {
    std::vector<KeptSlice> sorted = slices_;
    std::ranges::stable_sort(sorted, {}, &KeptSlice::track);
    append_tracks(bytes, sorted);
    append_column(bytes, sorted,
                  [this, before = static_cast<const KeptSlice*>(nullptr)](const KeptSlice& each) mutable {
                      const KeptSlice* last = std::exchange(before, &each);
                      return (each.begin - (last && last->track == each.track ? last->end : begin_)).count();
                  });
    append_column(bytes, sorted, [](const KeptSlice& each) { return (each.end - each.begin).count(); });
    append_column(bytes, sorted, [](const KeptSlice& each) { return each.doing + (each.open ? 16 : 0); });
    append_column(bytes, sorted, [](const KeptSlice& each) { return each.note; });
}

/// REQUIRES: they are sorted by track.
void Stretch::append_tracks(std::string& bytes, const std::vector<KeptSlice>& slices) {
    std::uint64_t tracks = 0;
    std::string each_track;
    for (auto slice = slices.begin(); slice != slices.end(); ++tracks) {
        auto behind = std::ranges::upper_bound(slice, slices.end(), slice->track, {}, &KeptSlice::track);
        append_number(each_track, slice->track);
        append_number(each_track, static_cast<std::uint64_t>(behind - slice));
        slice = behind;
    }
    append_number(bytes, tracks);
    bytes += each_track;
}

void Stretch::append_passages(std::string& bytes) const {
    std::vector<KeptPassage> sorted = passages_;
    std::ranges::stable_sort(sorted, {}, &KeptPassage::left);
    append_number(bytes, sorted.size());
    append_column(bytes, sorted, [](const KeptPassage& each) { return each.from; });
    append_column(bytes, sorted, [](const KeptPassage& each) { return each.to; });
    append_column(bytes, sorted, [before = begin_](const KeptPassage& each) mutable {
        return (each.left - std::exchange(before, each.left)).count();
    });
    append_column(bytes, sorted, [](const KeptPassage& each) { return (each.arrived - each.left).count(); });
    append_column(bytes, sorted, [](const KeptPassage& each) { return each.channel; });
}

} // namespace placedpar::page
