#include "observe/page/load_bins.hpp"

#include <algorithm>
#include <cmath>

namespace placedpar::page {

namespace {

void merge_pairs(std::vector<Time>& bins) {
    for (std::size_t i = 0; i < bins.size(); ++i)
        bins[i / 2] = (i % 2 == 0 ? Time{} : bins[i / 2]) + bins[i];
    bins.resize((bins.size() + 1) / 2);
}

/// Returns the level of a share, from 0 to 63. Any time above 0 gives at least level 1.
char level(Time part, Time whole) {
    constexpr int highest = 63;
    double share = static_cast<double>(part.count()) / static_cast<double>(whole.count());
    int number = std::clamp(static_cast<int>(std::lround(share * highest)), part > Time{} ? 1 : 0, highest);
    return level_digits[number];
}

} // namespace

LoadBins::LoadBins(std::size_t most_bins, Time origin) : most_bins_(most_bins), origin_(origin) {}

void LoadBins::add(std::size_t track, State state, Time begin, Time end) {
    if (end <= begin)
        return;
    while (bin_of(end - Time{1}) >= most_bins_)
        widen();
    if (track >= tracks_.size())
        tracks_.resize(track + 1);
    spread(state == State::running ? tracks_[track].running : tracks_[track].ready, begin, end);
}

void LoadBins::merge_to(std::size_t most_bins) {
    auto too_many = [most_bins](const Track& track) {
        return std::max(track.running.size(), track.ready.size()) > most_bins;
    };
    while (std::ranges::any_of(tracks_, too_many))
        widen();
}

std::string LoadBins::levels(std::size_t track, State state) const {
    std::string text;
    if (track < tracks_.size())
        for (Time part : state == State::running ? tracks_[track].running : tracks_[track].ready)
            text += level(part, width_);
    return text;
}

void LoadBins::widen() {
    width_ *= 2;
    for (Track& track : tracks_) {
        merge_pairs(track.running);
        merge_pairs(track.ready);
    }
}

void LoadBins::spread(Bins& bins, Time begin, Time end) const {
    std::size_t last = bin_of(end - Time{1});
    bins.resize(std::max(bins.size(), last + 1));
    for (std::size_t i = bin_of(begin); i <= last; ++i) {
        Time from = origin_ + static_cast<std::int64_t>(i) * width_;
        bins[i] += std::min(end, from + width_) - std::max(begin, from);
    }
}

} // namespace placedpar::page
