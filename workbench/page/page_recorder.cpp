#include "workbench/page/page_recorder.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace placedpar::page {

namespace {

/// A page that has all of them takes some ten megabytes.
constexpr std::size_t slices_of_each_end = 100'000, passages_of_each_end = 40'000;
/// Of all tracks together: each takes two bytes of the page.
constexpr std::size_t most_bins_together = 2'000'000;
/// Where every slice is kept, bins are only looked at from far away.
constexpr std::size_t bins_beside_all_slices = 1024;

std::size_t bins_for(std::size_t tracks) {
    return std::clamp<std::size_t>(std::bit_floor(most_bins_together / std::max<std::size_t>(tracks, 1)), 16, 8192);
}

bool is_running(Doing doing) { return doing == Doing::executes || doing == Doing::carries || doing == Doing::computes; }

const char* name_of(Track::Kind kind) {
    switch (kind) {
    case Track::Kind::processor: return "processor";
    case Track::Kind::process: return "process";
    case Track::Kind::machine_process: return "machine process";
    case Track::Kind::link: return "link";
    case Track::Kind::bus: return "bus";
    }
    return "";
}

/// In the order of Doing.
constexpr std::array<const char*, static_cast<std::size_t>(Doing::stopped) + 1> names_of_doing{
    "executes", "carries",    "ready", "computes",   "delayed", "outputs",
    "inputs",   "alternates", "joins", "after work", "stopped"};
static_assert(names_of_doing.back() != nullptr, "each has a name");

} // namespace

std::uint32_t TextTable::number_of(const std::string& text) {
    auto [found, is_new] = numbers_.emplace(text, static_cast<std::uint32_t>(texts_.size()));
    if (is_new)
        texts_.push_back(text);
    return found->second;
}

boost::json::array TextTable::json() const { return boost::json::array(texts_.begin(), texts_.end()); }

PageRecorder::PageRecorder(const Tracks& tracks, Time from)
    : tracks_(tracks), bins_(bins_for(tracks.all().size()), from), slices_(slices_of_each_end),
      passages_(passages_of_each_end) {}

void PageRecorder::write(const Slice& slice) {
    if (is_running(slice.doing))
        bins_.add(slice.track, LoadBins::State::running, slice.begin, slice.end);
    else if (slice.doing == Doing::ready)
        bins_.add(slice.track, LoadBins::State::ready, slice.begin, slice.end);
    slices_.add({static_cast<std::uint32_t>(slice.track), note_of(slice), static_cast<std::uint8_t>(slice.doing),
                 slice.open, slice.begin, slice.end});
}

/// The subject of what runs; of a wait a line for each channel, with the partner behind a tabulator.
std::uint32_t PageRecorder::note_of(const Slice& slice) {
    std::string note = slice.subject;
    for (const Awaited& each : slice.awaited)
        note += (note.empty() ? "" : "\n") + each.channel + "\t" + each.partner;
    if (slice.awaits_timer)
        note += note.empty() ? "its timer" : "\nits timer";
    return texts_.number_of(note);
}

void PageRecorder::write(const Passage& passage) {
    passages_.add({static_cast<std::uint32_t>(passage.from), static_cast<std::uint32_t>(passage.to),
                   texts_.number_of(passage.channel), passage.left, passage.arrived});
}

void PageRecorder::finish(Time begin, Time end, const std::string& why) {
    begin_ = begin;
    end_ = end;
    why_ = why;
}

boost::json::object PageRecorder::json() {
    if (slices_.left_out() == 0)
        bins_.merge_to(bins_beside_all_slices);
    boost::json::array path = path_json(); // before the texts: it names parts
    return {{"begin", begin_.count()},
            {"end", end_.count()},
            {"why", why_},
            {"bin", bins_.width().count()},
            {"left_out", slices_.left_out() + passages_.left_out()},
            {"doing", boost::json::array(names_of_doing.begin(), names_of_doing.end())},
            {"texts", texts_.json()},
            {"nodes", boost::json::array(tracks_.nodes().begin(), tracks_.nodes().end())},
            {"tracks", tracks_json()},
            {"messages", messages_json()},
            {"path", std::move(path)}};
}

boost::json::array PageRecorder::tracks_json() const {
    std::vector<std::vector<const KeptSlice*>> kept(tracks_.all().size());
    for (const KeptSlice& slice : slices_.first())
        kept[slice.track].push_back(&slice);
    std::vector<std::size_t> first;
    for (const auto& slices : kept)
        first.push_back(slices.size());
    for (const KeptSlice& slice : slices_.last())
        kept[slice.track].push_back(&slice);
    boost::json::array tracks(kept.size());
    for (std::size_t i = 0; i < kept.size(); ++i)
        tracks[i] = track_json(i, kept[i], first[i]);
    std::vector<std::size_t> drawn = tracks_.drawn();
    for (std::size_t place = 0; place < drawn.size(); ++place)
        tracks[drawn[place]].as_object()["place"] = place;
    return tracks;
}

/// The slices one after the other: [since the end of the one before, how long, what it does and 16 if it is open,
/// note]. Where some are left out behind the first ones, "lost" says from when to when.
boost::json::object PageRecorder::track_json(std::size_t number, const std::vector<const KeptSlice*>& slices,
                                             std::size_t first) const {
    const Track& track = tracks_.all()[number];
    boost::json::array flat;
    Time before = begin_;
    for (const KeptSlice* slice : slices) {
        flat.insert(flat.end(), {(slice->begin - before).count(), (slice->end - slice->begin).count(),
                                 slice->doing + (slice->open ? 16 : 0), slice->note});
        before = slice->end;
    }
    boost::json::object json{{"name", track.name},
                             {"node", track.place.node},
                             {"kind", name_of(track.place.kind)},
                             {"outermost", track.outermost},
                             {"running", bins_.levels(number, LoadBins::State::running)},
                             {"ready", bins_.levels(number, LoadBins::State::ready)},
                             {"slices", std::move(flat)}};
    if (slices_.left_out() > 0)
        json["lost"] = {(first > 0 ? slices[first - 1]->end : begin_).count(),
                        (first < slices.size() ? slices[first]->begin : end_).count()};
    return json;
}

boost::json::array PageRecorder::messages_json() const {
    boost::json::array flat;
    auto add = [&flat](const KeptPassage& each) {
        flat.insert(flat.end(),
                    {each.from, each.to, each.left.count(), (each.arrived - each.left).count(), each.channel});
    };
    std::ranges::for_each(passages_.first(), add);
    std::ranges::for_each(passages_.last(), add);
    return flat;
}

void PageRecorder::draw_path(std::span<const PathMark> path) {
    constexpr std::size_t most = 50'000;
    path_.assign(path.begin(), path.end());
    std::erase_if(path_, [this](const PathMark& mark) { return tracks_.of_place(mark.place) == Tracks::none; });
    if (path_.size() <= most)
        return;
    auto length = [](const PathMark& mark) { return mark.begin - mark.end; };
    std::ranges::nth_element(path_, path_.begin() + most, {}, length);
    path_.resize(most);
    std::ranges::sort(path_, {}, &PathMark::begin);
}

boost::json::array PageRecorder::path_json() {
    boost::json::array flat;
    for (const PathMark& mark : path_)
        flat.insert(flat.end(), {tracks_.of_place(mark.place), mark.begin.count(), (mark.end - mark.begin).count(),
                                 texts_.number_of(mark.name)});
    return flat;
}

} // namespace placedpar::page
