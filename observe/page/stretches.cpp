#include "observe/page/stretches.hpp"

#include "observe/page/encoding.hpp"

#include <algorithm>
#include <utility>

namespace placedpar::page {

namespace {

/// Returns the size of a full stretch. At its end each track may have one unfinished slice, which goes into another
/// row. A stretch has many entries for each track, so these slices are few.
std::size_t entries_for(std::size_t tracks, std::size_t at_least) {
    return std::max({at_least, std::min<std::size_t>(64 * tracks, 400'000), 4 * tracks});
}

} // namespace

Stretches::Stretches(const Tracks& tracks, Time from, const Room& room) : tracks_(tracks), from_(from), room_(room) {}

void Stretches::add(const Slice& slice) {
    Row& row = row_for(slice.begin);
    row.open.add(slice);
    pack_if_full(row);
}

void Stretches::add(const MessageArrow& arrow) {
    Row& row = row_for(arrow.left);
    row.open.add(arrow);
    pack_if_full(row);
}

/// Returns the row whose open stretch the entry can join. A new row keeps at most an eighth of the bytes of the
/// preceding row. The new row receives so few entries that it nevertheless fills up later than the preceding row.
Stretches::Row& Stretches::row_for(Time begin) {
    auto row = std::ranges::find_if(rows_, [begin](const Row& each) { return each.open.begin() <= begin; });
    if (row != rows_.end())
        return *row;
    return rows_.emplace_back(Row{Stretch(from_), BothEnds(room_.bytes_of_each_end >> (3 * rows_.size()))});
}

void Stretches::pack_if_full(Row& row) {
    if (row.open.entries() >= entries_for(tracks_.all().size(), room_.entries_of_stretch))
        pack(row);
}

void Stretches::pack(Row& row) {
    PackedStretch packed = row.open.pack();
    entries_ += packed.entries;
    if (!deflated_ && entries_ > room_.entries_at_once) {
        deflated_ = true;
        for (Row& each : rows_)
            each.kept.deflate();
    }
    if (deflated_)
        packed.bytes = deflated(packed.bytes);
    row.kept.add(std::move(packed));
}

void Stretches::finish() {
    for (Row& row : rows_)
        if (row.open.entries() > 0)
            pack(row);
}

std::size_t Stretches::left_out() const {
    std::size_t sum = 0;
    for (const Row& row : rows_)
        sum += row.kept.left_out();
    return sum;
}

std::optional<Period> Stretches::lost() const {
    std::optional<Period> all;
    for (const Row& row : rows_)
        if (std::optional<Period> lost = row.kept.lost())
            all = all ? Period{std::min(all->begin, lost->begin), std::max(all->end, lost->end)} : lost;
    return all;
}

std::vector<const PackedStretch*> Stretches::all() const {
    std::vector<const PackedStretch*> all;
    for (const Row& row : rows_)
        std::ranges::copy(row.kept.all(), std::back_inserter(all));
    return all;
}

} // namespace placedpar::page
