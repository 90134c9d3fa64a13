#include "observe/page/page_recorder.hpp"

#include <boost/json.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace placedpar::page {

namespace {

/// The greatest number of bins of all tracks together. Each bin takes two bytes of the page.
constexpr std::size_t most_bins_together = 2'000'000;
/// The greatest number of bins of each track if the page has all slices uncompressed. The bins then serve only the view
/// of the whole run.
constexpr std::size_t bins_beside_slices = 1024;

std::size_t bins_for(std::size_t tracks) {
    return std::clamp<std::size_t>(std::bit_floor(most_bins_together / std::max<std::size_t>(tracks, 1)), 16, 8192);
}

bool is_running(Activity activity) {
    return activity == Activity::executing || activity == Activity::carrying || activity == Activity::computing;
}

const char* name_of(Track::Kind kind) {
    switch (kind) {
    case Track::Kind::processor: return "processor";
    case Track::Kind::process: return "process";
    case Track::Kind::program: return "program";
    case Track::Kind::machine_process: return "machine process";
    case Track::Kind::link: return "link";
    case Track::Kind::bus: return "bus";
    }
    return "";
}

/// Names of the activities in the order of their numbers.
constexpr std::array<const char*, static_cast<std::size_t>(Activity::stopped) + 1> names_of_activities{
    "executes", "carries",    "ready", "computes",   "delayed", "outputs",
    "inputs",   "alternates", "joins", "after work", "stopped"};
static_assert(names_of_activities.back() != nullptr, "each has a name");

} // namespace

PageRecorder::PageRecorder(const Tracks& tracks, Time from)
    : tracks_(tracks), bins_(bins_for(tracks.all().size()), from), stretches_(tracks, from) {}

void PageRecorder::write(const Slice& slice) {
    if (is_running(slice.activity))
        bins_.add(slice.track, LoadBins::State::running, slice.begin, slice.end);
    else if (slice.activity == Activity::ready)
        bins_.add(slice.track, LoadBins::State::ready, slice.begin, slice.end);
    stretches_.add(slice);
}

void PageRecorder::write(const MessageArrow& arrow) { stretches_.add(arrow); }

void PageRecorder::finish(Time begin, Time end, const std::string& why) {
    begin_ = begin;
    end_ = end;
    why_ = why;
    stretches_.finish();
}

boost::json::object PageRecorder::json() {
    if (!stretches_.are_deflated())
        bins_.merge_to(bins_beside_slices);
    TextTable texts;
    boost::json::array path = path_json(texts);
    boost::json::object json{{"begin", begin_.count()},
                             {"end", end_.count()},
                             {"why", why_},
                             {"bin", bins_.width().count()},
                             {"left_out", stretches_.left_out()},
                             {"doing", boost::json::array(names_of_activities.begin(), names_of_activities.end())},
                             {"nodes", boost::json::array(tracks_.nodes().begin(), tracks_.nodes().end())},
                             {"tracks", tracks_json()},
                             {"deflated", stretches_.are_deflated()},
                             {"stretches", stretches_json()},
                             {"texts", texts.json()},
                             {"path", std::move(path)}};
    if (std::optional<Period> lost = stretches_.lost())
        json["lost"] = {lost->begin.count(), lost->end.count()};
    return json;
}

boost::json::array PageRecorder::stretches_json() const {
    boost::json::array flat;
    for (const PackedStretch* each : stretches_.all())
        flat.insert(flat.end(), {each->begin.count(), each->end.count(), each->entries});
    return flat;
}

boost::json::array PageRecorder::tracks_json() const {
    boost::json::array tracks(tracks_.all().size());
    for (std::size_t i = 0; i < tracks.size(); ++i)
        tracks[i] = track_json(i);
    std::vector<std::size_t> drawn = tracks_.drawn();
    for (std::size_t place = 0; place < drawn.size(); ++place)
        tracks[drawn[place]].as_object()["place"] = place;
    return tracks;
}

boost::json::object PageRecorder::track_json(std::size_t number) const {
    const Track& track = tracks_.all()[number];
    return {{"name", track.name},
            {"node", track.place.node},
            {"kind", name_of(track.place.kind)},
            {"outermost", track.outermost},
            {"running", bins_.levels(number, LoadBins::State::running)},
            {"ready", bins_.levels(number, LoadBins::State::ready)}};
}

void PageRecorder::draw_path(std::span<const PathPart> path) {
    constexpr std::size_t most = 50'000;
    path_.assign(path.begin(), path.end());
    std::erase_if(path_, [this](const PathPart& part) { return tracks_.of_place(part.place) == Tracks::none; });
    if (path_.size() <= most)
        return;
    auto length = [](const PathPart& part) { return part.begin - part.end; };
    std::ranges::nth_element(path_, path_.begin() + most, {}, length);
    path_.resize(most);
    std::ranges::sort(path_, {}, &PathPart::begin);
}

boost::json::array PageRecorder::path_json(TextTable& texts) const {
    boost::json::array flat;
    for (const PathPart& part : path_)
        flat.insert(flat.end(), {tracks_.of_place(part.place), part.begin.count(), (part.end - part.begin).count(),
                                 texts.number_of(name_on_path(part.activity, part.subject))});
    return flat;
}

} // namespace placedpar::page
